// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/choices.hpp>
#include <drivecodec/drives/smd/version.hpp>

#include <string_view>

// An enumerator's own name; empty for a value without one.

namespace drivecodec::smd {

[[nodiscard]] constexpr std::string_view to_string(version which) noexcept
{
    switch (which) {
    case version::pv400: return "pv400";
    case version::pv507: return "pv507";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(load_defaults code) noexcept
{
    switch (code) {
    case load_defaults::no_action: return "no_action";
    case load_defaults::load_50_hz_defaults: return "load_50_hz_defaults";
    case load_defaults::load_60_hz_defaults: return "load_60_hz_defaults";
    case load_defaults::load_oem_defaults: return "load_oem_defaults";
    case load_defaults::translate_compatible_epm: return "translate_compatible_epm";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(digital_input_function code) noexcept
{
    switch (code) {
    case digital_input_function::activate_fixed_setpoint_1: return "activate_fixed_setpoint_1";
    case digital_input_function::activate_fixed_setpoint_2: return "activate_fixed_setpoint_2";
    case digital_input_function::dc_braking: return "dc_braking";
    case digital_input_function::direction_of_rotation: return "direction_of_rotation";
    case digital_input_function::quick_stop: return "quick_stop";
    case digital_input_function::cw_rotation: return "cw_rotation";
    case digital_input_function::ccw_rotation: return "ccw_rotation";
    case digital_input_function::up: return "up";
    case digital_input_function::down: return "down";
    case digital_input_function::trip_set: return "trip_set";
    case digital_input_function::trip_reset: return "trip_reset";
    case digital_input_function::accel_decel_2: return "accel_decel_2";
    case digital_input_function::deactivate_pi: return "deactivate_pi";
    case digital_input_function::activate_fixed_pi_setpoint_1: return "activate_fixed_pi_setpoint_1";
    case digital_input_function::activate_fixed_pi_setpoint_2: return "activate_fixed_pi_setpoint_2";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(output_function code) noexcept
{
    switch (code) {
    case output_function::ready: return "ready";
    case output_function::fault: return "fault";
    case output_function::motor_is_running: return "motor_is_running";
    case output_function::motor_is_running_cw: return "motor_is_running_cw";
    case output_function::motor_is_running_ccw: return "motor_is_running_ccw";
    case output_function::output_frequency_is_0: return "output_frequency_is_0";
    case output_function::frequency_setpoint_reached: return "frequency_setpoint_reached";
    case output_function::threshold_exceeded: return "threshold_exceeded";
    case output_function::current_limit_reached: return "current_limit_reached";
    case output_function::feedback_within_alarm_range: return "feedback_within_alarm_range";
    case output_function::feedback_outside_alarm_range: return "feedback_outside_alarm_range";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(operating_mode code) noexcept
{
    switch (code) {
    case operating_mode::linear_with_auto_boost: return "linear_with_auto_boost";
    case operating_mode::square_law_with_auto_boost: return "square_law_with_auto_boost";
    case operating_mode::linear_with_constant_boost: return "linear_with_constant_boost";
    case operating_mode::square_law_with_constant_boost: return "square_law_with_constant_boost";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(chopper_frequency code) noexcept
{
    switch (code) {
    case chopper_frequency::chopper_4_khz: return "chopper_4_khz";
    case chopper_frequency::chopper_6_khz: return "chopper_6_khz";
    case chopper_frequency::chopper_8_khz: return "chopper_8_khz";
    case chopper_frequency::chopper_10_khz: return "chopper_10_khz";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(analog_input_deadband code) noexcept
{
    switch (code) {
    case analog_input_deadband::deadband_enabled: return "deadband_enabled";
    case analog_input_deadband::deadband_disabled: return "deadband_disabled";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(analog_input code) noexcept
{
    switch (code) {
    case analog_input::input_0_to_10_v: return "input_0_to_10_v";
    case analog_input::input_0_to_5_v: return "input_0_to_5_v";
    case analog_input::input_0_to_20_ma: return "input_0_to_20_ma";
    case analog_input::input_4_to_20_ma: return "input_4_to_20_ma";
    case analog_input::input_4_to_20_ma_monitored: return "input_4_to_20_ma_monitored";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(input_voltage code) noexcept
{
    switch (code) {
    case input_voltage::automatic: return "automatic";
    case input_voltage::low: return "low";
    case input_voltage::high: return "high";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(analog_output code) noexcept
{
    switch (code) {
    case analog_output::none: return "none";
    case analog_output::output_frequency_on_0_to_10_v: return "output_frequency_on_0_to_10_v";
    case analog_output::output_frequency_on_2_to_10_v: return "output_frequency_on_2_to_10_v";
    case analog_output::load_on_0_to_10_v: return "load_on_0_to_10_v";
    case analog_output::load_on_2_to_10_v: return "load_on_2_to_10_v";
    case analog_output::dynamic_braking: return "dynamic_braking";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(serial_format code) noexcept
{
    switch (code) {
    case serial_format::format_8n2: return "format_8n2";
    case serial_format::format_8n1: return "format_8n1";
    case serial_format::format_8e1: return "format_8e1";
    case serial_format::format_8o1: return "format_8o1";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(start_condition code) noexcept
{
    switch (code) {
    case start_condition::start_after_low_high_change: return "start_after_low_high_change";
    case start_condition::auto_start_if_high: return "auto_start_if_high";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(fault_mode code) noexcept
{
    switch (code) {
    case fault_mode::monitor_only: return "monitor_only";
    case fault_mode::monitor_and_edit: return "monitor_and_edit";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(trip_reset code) noexcept
{
    switch (code) {
    case trip_reset::reset_by_signal_or_mains: return "reset_by_signal_or_mains";
    case trip_reset::auto_reset: return "auto_reset";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(pi_enable code) noexcept
{
    switch (code) {
    case pi_enable::pi_disabled: return "pi_disabled";
    case pi_enable::pi_normal_acting: return "pi_normal_acting";
    case pi_enable::pi_reverse_acting: return "pi_reverse_acting";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(power_up_state code) noexcept
{
    switch (code) {
    case power_up_state::quick_stop: return "quick_stop";
    case power_up_state::inhibit: return "inhibit";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(serial_timeout_action code) noexcept
{
    switch (code) {
    case serial_timeout_action::not_active: return "not_active";
    case serial_timeout_action::controller_inhibit: return "controller_inhibit";
    case serial_timeout_action::quick_stop: return "quick_stop";
    case serial_timeout_action::trip_fault_fc3: return "trip_fault_fc3";
    }
    return {};
}

}  // namespace drivecodec::smd
