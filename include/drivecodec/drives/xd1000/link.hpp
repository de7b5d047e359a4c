// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/quantity.hpp>
#include <drivecodec/modbus/rtu/address.hpp>
#include <drivecodec/modbus/rtu/timing.hpp>

#include <array>

// The serial line. xD1000 manual, "Communication configuration".

namespace drivecodec::xd1000 {

/// Register 6003. The manual has the rates, but not the codes: those are its sister's, ATV12 parameter TBR, unverified.
enum class baud_rate : std::uint16_t {
    baud_4800  = 24,
    baud_9600  = 28,
    baud_19200 = 32,
    baud_38400 = 36,
};
inline constexpr std::array<std::uint16_t, 4> baud_rate_codes{24, 28, 32, 36};

/// Errors: `bad_value` at 0 for an unknown code.
[[nodiscard]] constexpr result<std::uint32_t> bits_per_second(baud_rate code) noexcept
{
    switch (code) {
    case baud_rate::baud_4800: return 4800U;
    case baud_rate::baud_9600: return 9600U;
    case baud_rate::baud_19200: return 19200U;
    case baud_rate::baud_38400: return 38400U;
    }
    return error{errc::bad_value, 0};
}

/// Register 6004. As `baud_rate`: the codes are those of ATV12 parameter TFO, unverified.
enum class character_format : std::uint16_t {
    format_8o1 = 2,
    format_8e1 = 3,
    format_8n1 = 4,
    format_8n2 = 5,
};
inline constexpr std::array<std::uint16_t, 4> character_format_codes{2, 3, 4, 5};

/// Errors: `bad_value` at 0 for an unknown code.
[[nodiscard]] constexpr result<modbus::rtu::character_format> to_rtu(character_format code) noexcept
{
    switch (code) {
    case character_format::format_8o1: return modbus::rtu::format_8o1;
    case character_format::format_8e1: return modbus::rtu::format_8e1;
    case character_format::format_8n1: return modbus::rtu::format_8n1;
    case character_format::format_8n2: return modbus::rtu::format_8n2;
    }
    return error{errc::bad_value, 0};
}

/// How a drive is set up; without arguments, as it leaves the factory.
struct link_settings {
    /// 1 to 247, or 0: OFF. A drive that is off answers nothing, yet carries out broadcasts.
    std::uint8_t             address  = 0;
    xd1000::baud_rate        baud     = baud_rate::baud_19200;
    xd1000::character_format format   = character_format::format_8e1;
    quantity<unit::second>   time_out = {100, -1};

    [[nodiscard]] constexpr bool is_off() const noexcept { return address == 0; }

    /// The silences of the line; a client keeps `inter_frame()` before each request. Errors: `bad_value` at 0 for an
    /// unknown code.
    [[nodiscard]] constexpr result<modbus::rtu::timing> timing() const noexcept
    {
        auto const rate  = bits_per_second(baud);
        auto const shape = to_rtu(format);
        if (not rate or not shape) { return error{errc::bad_value, 0}; }
        return modbus::rtu::timing::make(*rate, *shape);
    }

    friend constexpr bool operator==(link_settings const&, link_settings const&) noexcept = default;
};

/// What ends a frame for this drive, in microseconds: 3 characters, less than the 3.5 of the specification. So send
/// with `timing::inter_frame()` between frames, and take this much as the end of what the drive sends.
[[nodiscard]] constexpr std::uint32_t end_of_frame(modbus::rtu::timing line) noexcept
{
    return line.frame_time(3);
}

}  // namespace drivecodec::xd1000
