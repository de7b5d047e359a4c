// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>
#include <drivecodec/core/platform.hpp>

#include <cstring>

namespace drivecodec::fc {

/// The data control byte: the exclusive or of all bytes before it, STX included. VLT 6000 manual, "Data control byte
/// (BCC)".
///
/// It sees every single wrong bit, and every number of wrong bits that is odd in one of the eight columns. It does not
/// see two wrong bits in one column, nor bytes that changed places: parity, lengths and the pauses of the line have to.
class bcc {
public:
    constexpr bcc() noexcept = default;

    constexpr bcc& add(std::uint8_t byte) noexcept
    {
        value_ = static_cast<std::uint8_t>(value_ ^ byte);
        return *this;
    }

    constexpr bcc& add(bytes more) noexcept
    {
        std::size_t done = 0;
        if constexpr (is_host) {
            if (not std::is_constant_evaluated()) { done = add_blocks(more); }
        }
        auto folded = value_;
        for (; done < more.size(); ++done) { folded = static_cast<std::uint8_t>(folded ^ more.data()[done]); }
        value_ = folded;
        return *this;
    }

    /// Of the bytes so far. 0 where the last of them is their right BCC.
    [[nodiscard]] constexpr std::uint8_t value() const noexcept { return value_; }

    /// Of these bytes.
    [[nodiscard]] static constexpr std::uint8_t of(bytes covered) noexcept { return bcc{}.add(covered).value(); }

private:
    /// Eight bytes at a time; returns how many bytes it has done.
    std::size_t add_blocks(bytes more) noexcept
    {
        std::uint64_t folded = 0;
        std::size_t   done   = 0;
        for (; done + sizeof folded <= more.size(); done += sizeof folded) {
            std::uint64_t block{};
            std::memcpy(&block, more.data() + done, sizeof block);
            folded ^= block;
        }
        folded ^= folded >> 32;
        folded ^= folded >> 16;
        folded ^= folded >> 8;
        add(static_cast<std::uint8_t>(folded));
        return done;
    }

    std::uint8_t value_ = 0;
};

}  // namespace drivecodec::fc
