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

    [[nodiscard]] constexpr bool        is_exact() const noexcept { return what() == kind::exact; }
    [[nodiscard]] constexpr bool        is_open() const noexcept { return what() == kind::open; }
    [[nodiscard]] constexpr bool        is_until_silence() const noexcept { return what() == kind::silence; }
    [[nodiscard]] constexpr bool        is_impossible() const noexcept { return what() == kind::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return packed_ >> kind_bits; }

    /// The length of a message that has `around` more bytes about this one.
    [[nodiscard]] constexpr message_length plus(std::size_t around) const noexcept
    {
        return is_exact() or is_open() ? message_length{what(), size() + around} : *this;
    }

    friend constexpr bool operator==(message_length, message_length) noexcept = default;

private:
    enum class kind : std::uint8_t { none, exact, open, silence };

    static constexpr unsigned kind_bits = 2;

    constexpr message_length(kind what, std::size_t size) noexcept
        : packed_{std::uint32_t{saturate_16(size)} << kind_bits | static_cast<std::uint32_t>(what)}
    {}

    [[nodiscard]] constexpr kind what() const noexcept { return static_cast<kind>(packed_ & ((1U << kind_bits) - 1U)); }

    // One number, so that it comes back in a register and is not taken apart in memory.
    std::uint32_t packed_;
};

}  // namespace drivecodec
