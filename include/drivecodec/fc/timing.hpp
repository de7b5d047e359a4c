// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

#include <array>

namespace drivecodec::fc {

namespace compile_error {
// Declared, never defined, not constexpr: calling it is how a consteval function says no. Its name is the text.
void baud_rate_must_be_positive();
}  // namespace compile_error

/// Every character has a start bit, eight data bits, an even parity bit and a stop bit: eleven. VLT 6000 manual,
/// "Contents of a character (byte)".
inline constexpr std::uint32_t bits_per_character = 11;

/// Of parameter 502, in the order of its choices, and those of newer FC guides. Others work as well.
inline constexpr std::array<std::uint32_t, 6> vlt_baud_rates{300, 600, 1200, 2400, 4800, 9600};
inline constexpr std::array<std::uint32_t, 7> fc_baud_rates{2400, 4800, 9600, 19200, 38400, 57600, 115200};

/// The times of the line, in microseconds, rounded up. VLT 6000 manual, "Telegram build-up" and "Telegram times".
class timing {
public:
    /// Of a constant baud rate; one of zero or less does not compile.
    [[nodiscard]] static consteval timing of(std::int32_t baud)
    {
        if (baud <= 0) { compile_error::baud_rate_must_be_positive(); }
        return timing{static_cast<std::uint32_t>(baud)};
    }

    /// Of a baud rate known only at run time. Errors: `bad_value` at 0 for a baud rate of zero.
    [[nodiscard]] static constexpr result<timing> make(std::uint32_t baud) noexcept
    {
        if (baud == 0) { return error{errc::bad_value, 0}; }
        return timing{baud};
    }

    [[nodiscard]] constexpr std::uint32_t character() const noexcept { return characters(1); }

    /// Between two characters of one telegram there is less than this: two characters.
    [[nodiscard]] constexpr std::uint32_t gap() const noexcept { return characters(2); }

    /// Before each telegram the line is silent at least as long: two characters. The manual has this number in both
    /// rules; a telegram begins only behind such a pause. Both are from the end of a character to the start of the next.
    [[nodiscard]] constexpr std::uint32_t pause() const noexcept { return characters(2); }

    /// When nothing was received for so long, there was a pause: a reader's `silence`. One character more than `pause()`,
    /// since who receives sees a character only when it is complete, and it may have begun just before the pause was over.
    [[nodiscard]] constexpr std::uint32_t silence() const noexcept { return characters(3); }

    /// The time `size` bytes take without gaps. Precondition: size <= 256, the longest telegram.
    [[nodiscard]] constexpr std::uint32_t telegram(std::size_t size) const noexcept
    {
        return characters(static_cast<std::uint32_t>(size));
    }

    /// The time within which a telegram of `size` bytes has to be complete: one and a half times its own.
    /// Precondition: as above.
    [[nodiscard]] constexpr std::uint32_t telegram_limit(std::size_t size) const noexcept
    {
        return microseconds(3 * static_cast<std::uint64_t>(size) * bits_per_character, 2 * std::uint64_t{baud_});
    }

    /// A slave begins its response after at least `pause()`, and at most this. The first edition of the manual says 20
    /// ms: wait for the longer one, and some more.
    static constexpr std::uint32_t response_limit = 50'000;

    friend constexpr bool operator==(timing, timing) noexcept = default;

private:
    constexpr explicit timing(std::uint32_t baud) noexcept : baud_{baud} {}

    [[nodiscard]] constexpr std::uint32_t characters(std::uint32_t count) const noexcept
    {
        return microseconds(std::uint64_t{count} * bits_per_character, baud_);
    }

    /// Below 2^32 also for the limit of the longest telegram at one baud, which is 4224 s.
    [[nodiscard]] static constexpr std::uint32_t microseconds(std::uint64_t bits, std::uint64_t per_second) noexcept
    {
        return static_cast<std::uint32_t>((bits * 1'000'000 + per_second - 1) / per_second);
    }

    std::uint32_t baud_;
};

}  // namespace drivecodec::fc
