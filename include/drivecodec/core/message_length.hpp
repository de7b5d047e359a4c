// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>

namespace drivecodec {

/// What the first bytes of a message say about its length. A stream reader asks it again when more bytes came.
class message_length {
public:
    /// The whole message has `size` bytes.
    [[nodiscard]] static constexpr message_length exactly(std::size_t size) noexcept { return {kind::exact, size}; }

    /// Only with `size` bytes can more be said; the message is at least that long.
    [[nodiscard]] static constexpr message_length at_least(std::size_t size) noexcept { return {kind::open, size}; }

    /// No field tells: the message ends where the line falls silent.
    [[nodiscard]] static constexpr message_length until_silence() noexcept { return {kind::silence, 0}; }

    /// No message begins like this.
    [[nodiscard]] static constexpr message_length impossible() noexcept { return {kind::none, 0}; }

    [[nodiscard]] constexpr bool        is_exact() const noexcept { return kind_ == kind::exact; }
    [[nodiscard]] constexpr bool        is_open() const noexcept { return kind_ == kind::open; }
    [[nodiscard]] constexpr bool        is_until_silence() const noexcept { return kind_ == kind::silence; }
    [[nodiscard]] constexpr bool        is_impossible() const noexcept { return kind_ == kind::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }

    /// The length of a message that has `around` more bytes about this one.
    [[nodiscard]] constexpr message_length plus(std::size_t around) const noexcept
    {
        return is_exact() or is_open() ? message_length{kind_, size_ + around} : *this;
    }

    friend constexpr bool operator==(message_length, message_length) noexcept = default;

private:
    enum class kind : std::uint8_t { none, exact, open, silence };

    constexpr message_length(kind what, std::size_t size) noexcept : size_{saturate_16(size)}, kind_{what} {}

    std::uint16_t size_;
    kind          kind_;
};

}  // namespace drivecodec
