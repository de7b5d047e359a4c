// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

#include <array>

// Who gives the drive its speed and its commands, and who programs it. smd manual, tables 4 and 13.

namespace drivecodec::smd {

/// Parameter C01, and the low byte of register 27. A name says speed, control and program source; one that is the same
/// as the one before is not said again.
enum class control_mode : std::uint16_t {
    analog_terminal_keypad        = 0,
    c40_terminal_keypad           = 1,
    analog_terminal_lecom         = 2,
    lecom                         = 3,
    analog_terminal_remote_keypad = 4,
    c40_terminal_remote_keypad    = 5,
    analog_remote_keypad          = 6,
    c40_remote_keypad             = 7,
    analog_terminal_modbus        = 8,
    c40_terminal_modbus           = 9,
    analog_modbus                 = 10,
    c40_modbus                    = 11,
};
inline constexpr std::array<std::uint16_t, 12> control_mode_codes{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};

/// The speed, as long as nothing else is chosen, such as a preset or the serial reference.
enum class setpoint_source : std::uint8_t { analog, c40, lecom };

/// Start, stop and direction.
enum class control_source : std::uint8_t { terminal, lecom, remote_keypad, modbus };

/// Parameters and monitoring.
enum class program_source : std::uint8_t { keypad, lecom, remote_keypad, modbus };

/// Errors: `bad_value` at 0 for an unknown mode.
[[nodiscard]] constexpr result<setpoint_source> setpoint_source_of(control_mode mode) noexcept
{
    auto const number = static_cast<unsigned>(mode);
    if (number >= control_mode_codes.size()) { return error{errc::bad_value, 0}; }
    if (mode == control_mode::lecom) { return setpoint_source::lecom; }
    return number % 2 == 0 ? setpoint_source::analog : setpoint_source::c40;
}

/// Errors: `bad_value` at 0 for an unknown mode.
[[nodiscard]] constexpr result<control_source> control_source_of(control_mode mode) noexcept
{
    switch (mode) {
    case control_mode::analog_terminal_keypad:
    case control_mode::c40_terminal_keypad:
    case control_mode::analog_terminal_lecom:
    case control_mode::analog_terminal_remote_keypad:
    case control_mode::c40_terminal_remote_keypad:
    case control_mode::analog_terminal_modbus:
    case control_mode::c40_terminal_modbus: return control_source::terminal;
    case control_mode::lecom: return control_source::lecom;
    case control_mode::analog_remote_keypad:
    case control_mode::c40_remote_keypad: return control_source::remote_keypad;
    case control_mode::analog_modbus:
    case control_mode::c40_modbus: return control_source::modbus;
    }
    return error{errc::bad_value, 0};
}

/// Errors: `bad_value` at 0 for an unknown mode.
[[nodiscard]] constexpr result<program_source> program_source_of(control_mode mode) noexcept
{
    switch (mode) {
    case control_mode::analog_terminal_keypad:
    case control_mode::c40_terminal_keypad: return program_source::keypad;
    case control_mode::analog_terminal_lecom:
    case control_mode::lecom: return program_source::lecom;
    case control_mode::analog_terminal_remote_keypad:
    case control_mode::c40_terminal_remote_keypad:
    case control_mode::analog_remote_keypad:
    case control_mode::c40_remote_keypad: return program_source::remote_keypad;
    case control_mode::analog_terminal_modbus:
    case control_mode::c40_terminal_modbus:
    case control_mode::analog_modbus:
    case control_mode::c40_modbus: return program_source::modbus;
    }
    return error{errc::bad_value, 0};
}

/// Can a Modbus master start, stop and reverse the drive, once it has unlocked it?
[[nodiscard]] constexpr bool modbus_controls(control_mode mode) noexcept
{
    return mode == control_mode::analog_modbus or mode == control_mode::c40_modbus;
}

/// Can a Modbus master only watch the drive, which its terminals control?
[[nodiscard]] constexpr bool modbus_monitors(control_mode mode) noexcept
{
    return mode == control_mode::analog_terminal_modbus or mode == control_mode::c40_terminal_modbus;
}

}  // namespace drivecodec::smd
