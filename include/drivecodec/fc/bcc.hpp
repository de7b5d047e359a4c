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

    constexpr bcc& add(bytes more) noexcept { return add(of(more)); }

    /// Of the bytes so far. 0 where the last of them is their right BCC.
    [[nodiscard]] constexpr std::uint8_t value() const noexcept { return value_; }

    /// Of these bytes.
    [[nodiscard]] static constexpr std::uint8_t of(bytes covered) noexcept
    {
        return fold(covered.data(), covered.size());
    }

private:
    // Not of a span, which g++ puts into memory where it is passed: that is a fifteenth of a master's code.
    [[nodiscard]] static constexpr std::uint8_t fold(std::uint8_t const* from, std::size_t size) noexcept
    {
        std::uint8_t folded = 0;
        std::size_t  done   = 0;
        if constexpr (is_host) {
            if (not std::is_constant_evaluated()) {
                done   = size - size % block_size;
                folded = fold_blocks(from, done);
            }
        }
        for (; done < size; ++done) { folded = static_cast<std::uint8_t>(folded ^ from[done]); }
        return folded;
    }

    /// Of whole blocks.
    [[nodiscard]] static std::uint8_t fold_blocks(std::uint8_t const* from, std::size_t size) noexcept
    {
        std::uint64_t folded = 0;
        for (std::size_t done = 0; done < size; done += block_size) {
            std::uint64_t block{};
            std::memcpy(&block, from + done, block_size);
            folded ^= block;
        }
        folded ^= folded >> 32;
        folded ^= folded >> 16;
        folded ^= folded >> 8;
        return static_cast<std::uint8_t>(folded);
    }

    static constexpr std::size_t block_size = sizeof(std::uint64_t);

    std::uint8_t value_ = 0;
};

}  // namespace drivecodec::fc
