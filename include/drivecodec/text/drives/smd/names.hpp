// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/command.hpp>
#include <drivecodec/drives/smd/control_mode.hpp>
#include <drivecodec/drives/smd/family.hpp>
#include <drivecodec/drives/smd/operational_status.hpp>
#include <drivecodec/drives/smd/speed_source.hpp>
#include <drivecodec/text/drives/direction.hpp>

#include <string_view>

// An enumerator's own name; empty for a value without one.

namespace drivecodec::smd {

[[nodiscard]] constexpr std::string_view to_string(command given) noexcept
{
    switch (given) {
    case command::update_buffers: return "update_buffers";
    case command::lock: return "lock";
    case command::stop: return "stop";
    case command::start: return "start";
    case command::set_reverse: return "set_reverse";
    case command::set_forward: return "set_forward";
    case command::serial_speed_reference: return "serial_speed_reference";
    case command::local_speed_reference: return "local_speed_reference";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(command_fault why) noexcept
{
    switch (why) {
    case command_fault::no_command: return "no_command";
    case command_fault::unused_bit: return "unused_bit";
    case command_fault::several_with_stop: return "several_with_stop";
    case command_fault::several: return "several";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(family of) noexcept
{
    switch (of) {
    case family::qc: return "qc";
    case family::mc: return "mc";
    case family::sc: return "sc";
    case family::mch: return "mch";
    case family::smd: return "smd";
    case family::tc: return "tc";
    case family::tmd: return "tmd";
    case family::smv: return "smv";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(operational_status status) noexcept
{
    switch (status) {
    case operational_status::fault_lockout: return "fault_lockout";
    case operational_status::fault: return "fault";
    case operational_status::start_pending: return "start_pending";
    case operational_status::stop: return "stop";
    case operational_status::dc_brake: return "dc_brake";
    case operational_status::run_at_0_hz: return "run_at_0_hz";
    case operational_status::run: return "run";
    case operational_status::accel: return "accel";
    case operational_status::decel: return "decel";
    case operational_status::current_limit: return "current_limit";
    case operational_status::decel_override: return "decel_override";
    case operational_status::lower_transistors_switching_on: return "lower_transistors_switching_on";
    case operational_status::off: return "off";
    case operational_status::inhibit: return "inhibit";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(control_mode mode) noexcept
{
    switch (mode) {
    case control_mode::analog_terminal_keypad: return "analog_terminal_keypad";
    case control_mode::c40_terminal_keypad: return "c40_terminal_keypad";
    case control_mode::analog_terminal_lecom: return "analog_terminal_lecom";
    case control_mode::lecom: return "lecom";
    case control_mode::analog_terminal_remote_keypad: return "analog_terminal_remote_keypad";
    case control_mode::c40_terminal_remote_keypad: return "c40_terminal_remote_keypad";
    case control_mode::analog_remote_keypad: return "analog_remote_keypad";
    case control_mode::c40_remote_keypad: return "c40_remote_keypad";
    case control_mode::analog_terminal_modbus: return "analog_terminal_modbus";
    case control_mode::c40_terminal_modbus: return "c40_terminal_modbus";
    case control_mode::analog_modbus: return "analog_modbus";
    case control_mode::c40_modbus: return "c40_modbus";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(setpoint_source from) noexcept
{
    switch (from) {
    case setpoint_source::analog: return "analog";
    case setpoint_source::c40: return "c40";
    case setpoint_source::lecom: return "lecom";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(control_source from) noexcept
{
    switch (from) {
    case control_source::terminal: return "terminal";
    case control_source::lecom: return "lecom";
    case control_source::remote_keypad: return "remote_keypad";
    case control_source::modbus: return "modbus";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(program_source from) noexcept
{
    switch (from) {
    case program_source::keypad: return "keypad";
    case program_source::lecom: return "lecom";
    case program_source::remote_keypad: return "remote_keypad";
    case program_source::modbus: return "modbus";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(speed_source from) noexcept
{
    switch (from) {
    case speed_source::analog: return "analog";
    case speed_source::preset_c40: return "preset_c40";
    case speed_source::preset_1: return "preset_1";
    case speed_source::preset_2: return "preset_2";
    case speed_source::preset_3: return "preset_3";
    case speed_source::mop: return "mop";
    case speed_source::serial: return "serial";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(speed_reference chosen) noexcept
{
    switch (chosen) {
    case speed_reference::serial: return "serial";
    case speed_reference::local: return "local";
    }
    return {};
}

}  // namespace drivecodec::smd
