// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

#include <cstddef>
#include <cstdint>

namespace drivecodec::modbus::rtu {

// Declared, never defined, not constexpr: calling it is how a consteval function says no.
namespace compile_error {
void baud_rate_must_be_positive();
}  // namespace compile_error

enum class parity : std::uint8_t { none, even, odd };

enum class stop_bits : std::uint8_t { one = 1, two = 2 };

/// How a byte travels on the line: start bit, eight data bits, parity bit or none, stop bits.
struct character_format {
    static constexpr unsigned data_bits = 8;

    rtu::parity    parity    = rtu::parity::even;
    rtu::stop_bits stop_bits = rtu::stop_bits::one;

    /// 10 to 12; the specification wants 11.
    [[nodiscard]] constexpr unsigned bits_per_character() const noexcept
    {
        constexpr unsigned start_bit = 1;
        return start_bit + data_bits + (parity == rtu::parity::none ? 0U : 1U) + static_cast<unsigned>(stop_bits);
    }

    friend constexpr bool operator==(character_format, character_format) noexcept = default;
};

inline constexpr character_format format_8e1{parity::even, stop_bits::one};  ///< The specification's default.
inline constexpr character_format format_8o1{parity::odd, stop_bits::one};
inline constexpr character_format format_8n2{parity::none, stop_bits::two};
inline constexpr character_format format_8n1{parity::none, stop_bits::one};  ///< Not in the specification, but common.

/// The silences that separate the frames of a line, in microseconds, rounded up.
/// MODBUS over Serial Line V1.02, 2.5.1.1.
class timing {
public:
    /// Above this baud rate the silences no longer shrink, to spare the processors their interrupts.
    static constexpr std::uint32_t fastest_scaled_baud = 19200;

    /// Of a constant baud rate; one of zero or less does not compile.
    [[nodiscard]] static consteval timing of(std::int32_t baud, character_format format = format_8e1)
    {
        if (baud <= 0) { compile_error::baud_rate_must_be_positive(); }
        return {static_cast<std::uint32_t>(baud), format};
    }

    /// Of a baud rate known only at run time. Errors: `bad_value` at 0 for a baud rate of zero.
    [[nodiscard]] static constexpr result<timing> make(std::uint32_t    baud,
                                                       character_format format = format_8e1) noexcept
    {
        if (baud == 0) { return error{errc::bad_value, 0}; }
        return timing{baud, format};
    }

    /// The time one character takes.
    [[nodiscard]] constexpr std::uint32_t character() const noexcept { return frame_time(1); }

    /// t1.5: a longer silence inside a frame makes the frame incomplete.
    [[nodiscard]] constexpr std::uint32_t inter_character() const noexcept { return inter_character_; }

    /// t3.5: a silence of this length or more ends a frame.
    [[nodiscard]] constexpr std::uint32_t inter_frame() const noexcept { return inter_frame_; }

    /// The time `length` characters take that follow each other without a pause.
    /// Precondition: length <= 256, the longest frame.
    [[nodiscard]] constexpr std::uint32_t frame_time(std::size_t length) const noexcept
    {
        return microseconds(static_cast<std::uint32_t>(length) * bits_, baud_);
    }

    friend constexpr bool operator==(timing, timing) noexcept = default;

private:
    constexpr timing(std::uint32_t baud, character_format format) noexcept
        : baud_{baud}, bits_{format.bits_per_character()},
          inter_character_{baud > fastest_scaled_baud ? 750 : microseconds(3 * bits_, 2 * baud)},
          inter_frame_{baud > fastest_scaled_baud ? 1750 : microseconds(7 * bits_, 2 * baud)}
    {}

    /// Below 2^32 for the longest frame of the longest characters at one baud: 256 * 12 * 10^6 = 3,072,000,000.
    [[nodiscard]] static constexpr std::uint32_t microseconds(std::uint32_t bits, std::uint32_t per_second) noexcept
    {
        auto const scaled = bits * 1'000'000;
        return scaled / per_second + (scaled % per_second != 0 ? 1 : 0);
    }

    std::uint32_t baud_;
    std::uint32_t bits_;
    std::uint32_t inter_character_;
    std::uint32_t inter_frame_;
};

}  // namespace drivecodec::modbus::rtu
