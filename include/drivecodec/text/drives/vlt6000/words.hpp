// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/vlt6000/alarm_word.hpp>
#include <drivecodec/drives/vlt6000/control_word.hpp>
#include <drivecodec/drives/vlt6000/extended_status_word.hpp>
#include <drivecodec/drives/vlt6000/status_word.hpp>
#include <drivecodec/drives/vlt6000/warning_word.hpp>
#include <drivecodec/text/drives/vlt6000/names.hpp>
#include <drivecodec/text/flags.hpp>

namespace drivecodec::vlt6000 {

//=== names of bits: what a 1 means ===//

namespace detail {

template <typename Word, std::size_t N>
using names_of_flags = std::array<flag_name<Word>, N>;

// clang-format off
inline constexpr names_of_flags<control_word, 5> control_flags{{
    {control_word::reset, "reset"},
    {control_word::jog, "jog"},
    {control_word::relay_1, "relay_1"},
    {control_word::relay_2, "relay_2"},
    {control_word::reversing, "reversing"},
}};
inline constexpr names_of_flags<status_word, 11> status_flags{{
    {status_word::control_ready, "control_ready"},
    {status_word::drive_ready, "drive_ready"},
    {status_word::stand_by, "stand_by"},
    {status_word::tripped, "tripped"},
    {status_word::warning, "warning"},
    {status_word::speed_equals_reference, "speed_equals_reference"},
    {status_word::within_frequency_range, "within_frequency_range"},
    {status_word::running, "running"},
    {status_word::voltage_warning, "voltage_warning"},
    {status_word::current_limit, "current_limit"},
    {status_word::thermal_warning, "thermal_warning"},
}};
inline constexpr names_of_flags<extended_status_word, 31> extended_status_flags{{
    {extended_status_word::overvoltage_control_active, "overvoltage_control_active"},
    {extended_status_word::start_delay, "start_delay"},
    {extended_status_word::sleep_boost_active, "sleep_boost_active"},
    {extended_status_word::sleep_mode_active, "sleep_mode_active"},
    {extended_status_word::automatic_motor_adaptation_completed, "automatic_motor_adaptation_completed"},
    {extended_status_word::automatic_motor_adaptation_running, "automatic_motor_adaptation_running"},
    {extended_status_word::reversing_and_start, "reversing_and_start"},
    {extended_status_word::ramp_operation, "ramp_operation"},
    {extended_status_word::reversing, "reversing"},
    {extended_status_word::speed_equals_reference, "speed_equals_reference"},
    {extended_status_word::running, "running"},
    {extended_status_word::remote_controlled_reference, "remote_controlled_reference"},
    {extended_status_word::off_mode, "off_mode"},
    {extended_status_word::hand_mode, "hand_mode"},
    {extended_status_word::start_blocked, "start_blocked"},
    {extended_status_word::start_blocked_signal_missing, "start_blocked_signal_missing"},
    {extended_status_word::freeze_output, "freeze_output"},
    {extended_status_word::freeze_output_blocked, "freeze_output_blocked"},
    {extended_status_word::jogging, "jogging"},
    {extended_status_word::jog_blocked, "jog_blocked"},
    {extended_status_word::stand_by, "stand_by"},
    {extended_status_word::stop, "stop"},
    {extended_status_word::dc_stop, "dc_stop"},
    {extended_status_word::drive_ready_23, "drive_ready_23"},
    {extended_status_word::relay_123_active, "relay_123_active"},
    {extended_status_word::drive_ready_25, "drive_ready_25"},
    {extended_status_word::control_ready, "control_ready"},
    {extended_status_word::start_prevented, "start_prevented"},
    {extended_status_word::profibus_off3_active, "profibus_off3_active"},
    {extended_status_word::profibus_off2_active, "profibus_off2_active"},
    {extended_status_word::profibus_off1_active, "profibus_off1_active"},
}};
inline constexpr names_of_flags<warning_word, 30> warning_flags{{
    {warning_word::reference_high, "reference_high"},
    {warning_word::fault_in_eeprom_on_control_card, "fault_in_eeprom_on_control_card"},
    {warning_word::fault_in_eeprom_on_power_card, "fault_in_eeprom_on_power_card"},
    {warning_word::hpfb_bus_timeout, "hpfb_bus_timeout"},
    {warning_word::serial_communication_timeout, "serial_communication_timeout"},
    {warning_word::overcurrent, "overcurrent"},
    {warning_word::current_limit, "current_limit"},
    {warning_word::motor_thermistor, "motor_thermistor"},
    {warning_word::motor_overtemperature, "motor_overtemperature"},
    {warning_word::inverter_overtemperature, "inverter_overtemperature"},
    {warning_word::undervoltage, "undervoltage"},
    {warning_word::overvoltage, "overvoltage"},
    {warning_word::voltage_warning_low, "voltage_warning_low"},
    {warning_word::voltage_warning_high, "voltage_warning_high"},
    {warning_word::mains_phase_fault, "mains_phase_fault"},
    {warning_word::live_zero_fault, "live_zero_fault"},
    {warning_word::under_10_volt, "under_10_volt"},
    {warning_word::reference_low, "reference_low"},
    {warning_word::feedback_high, "feedback_high"},
    {warning_word::feedback_low, "feedback_low"},
    {warning_word::output_current_high, "output_current_high"},
    {warning_word::out_of_frequency_range, "out_of_frequency_range"},
    {warning_word::profibus_communication_fault, "profibus_communication_fault"},
    {warning_word::output_current_low, "output_current_low"},
    {warning_word::output_frequency_high, "output_frequency_high"},
    {warning_word::output_frequency_low, "output_frequency_low"},
    {warning_word::ama_motor_too_small, "ama_motor_too_small"},
    {warning_word::ama_motor_too_big, "ama_motor_too_big"},
    {warning_word::ama_check_parameters_102_103_105, "ama_check_parameters_102_103_105"},
    {warning_word::ama_check_parameters_102_104_106, "ama_check_parameters_102_104_106"},
}};
inline constexpr names_of_flags<alarm_word, 28> alarm_flags{{
    {alarm_word::unknown_fault, "unknown_fault"},
    {alarm_word::trip_locked, "trip_locked"},
    {alarm_word::auto_optimisation_not_ok, "auto_optimisation_not_ok"},
    {alarm_word::hpfb_bus_timeout, "hpfb_bus_timeout"},
    {alarm_word::serial_communication_timeout, "serial_communication_timeout"},
    {alarm_word::asic_fault, "asic_fault"},
    {alarm_word::hpfp_bus_timeout, "hpfp_bus_timeout"},
    {alarm_word::standard_bus_timeout, "standard_bus_timeout"},
    {alarm_word::short_circuiting, "short_circuiting"},
    {alarm_word::switchmode_fault, "switchmode_fault"},
    {alarm_word::earth_fault, "earth_fault"},
    {alarm_word::current_limit, "current_limit"},
    {alarm_word::overcurrent, "overcurrent"},
    {alarm_word::motor_thermistor, "motor_thermistor"},
    {alarm_word::motor_overheated, "motor_overheated"},
    {alarm_word::inverter_overheated, "inverter_overheated"},
    {alarm_word::undervoltage, "undervoltage"},
    {alarm_word::overvoltage, "overvoltage"},
    {alarm_word::mains_phase_fault, "mains_phase_fault"},
    {alarm_word::live_zero_fault, "live_zero_fault"},
    {alarm_word::heat_sink_temperature_too_high, "heat_sink_temperature_too_high"},
    {alarm_word::motor_phase_w_missing, "motor_phase_w_missing"},
    {alarm_word::motor_phase_v_missing, "motor_phase_v_missing"},
    {alarm_word::motor_phase_u_missing, "motor_phase_u_missing"},
    {alarm_word::profibus_communication_fault, "profibus_communication_fault"},
    {alarm_word::inverter_fault, "inverter_fault"},
    {alarm_word::output_current_low, "output_current_low"},
    {alarm_word::safety_stop, "safety_stop"},
}};
// clang-format on

template <typename Word, std::size_t N>
constexpr void write_word(text_writer& out, Word word, names_of_flags<Word, N> const& names) noexcept
{
    out.hex(word.raw);
    write_flags(out, word, names);
}

}  // namespace detail

//=== the words of a telegram ===//

/// `CTW 047F start preset_reference_4 setup_1`, and what else the word commands. The bits that command something at 0
/// are told by that: `CTW 0417 ramp_stop coasting_stop freeze_output preset_reference_4 setup_1`. A word that the drive
/// ignores says so: `CTW 007F data_not_valid start preset_reference_4 setup_1`. Bit 9 comes last: `+0200`.
constexpr void write_text(text_writer& out, control_word word) noexcept
{
    out.put("CTW ").hex(word.raw);
    if (not word.test(control_word::data_valid)) { out.put(" data_not_valid"); }
    out.put(word.test(control_word::start) ? " start" : " ramp_stop");
    if (not word.test(control_word::no_dc_brake)) { out.put(" dc_brake"); }
    if (not word.test(control_word::no_coasting_stop)) { out.put(" coasting_stop"); }
    if (not word.test(control_word::no_quick_stop)) { out.put(" quick_stop"); }
    if (not word.test(control_word::no_freeze_output)) { out.put(" freeze_output"); }
    out.put(' ').put(to_string(word.get(control_word::preset_reference)));
    out.put(' ').put(to_string(word.get(control_word::setup)));

    constexpr std::uint16_t told{0x647F};  // by everything above
    write_flags(out, control_word::from_raw(static_cast<std::uint16_t>(word.raw & ~told)), detail::control_flags);
}

/// `STW 0F03 serial_control control_ready drive_ready speed_equals_reference within_frequency_range running`, or
/// `local_operation`; then what is 1. Bits that are not used come last: `+0010`.
constexpr void write_text(text_writer& out, status_word status) noexcept
{
    out.put("STW ").hex(status.raw).put(status.is_local() ? " local_operation" : " serial_control");
    write_flags(out, status.without(status_word::serial_control), detail::status_flags);
}

//=== the words of parameters 529, 531 and 532; reserved bits come last: `+80000000` ===//

/// `00000402 trip_locked earth_fault`; without an alarm the number alone.
constexpr void write_text(text_writer& out, alarm_word alarms) noexcept
{
    detail::write_word(out, alarms, detail::alarm_flags);
}

/// `00008020 overcurrent live_zero_fault`; without a warning the number alone.
constexpr void write_text(text_writer& out, warning_word warnings) noexcept
{
    detail::write_word(out, warnings, detail::warning_flags);
}

/// `06000600 speed_equals_reference running drive_ready_25 control_ready`
constexpr void write_text(text_writer& out, extended_status_word status) noexcept
{
    detail::write_word(out, status, detail::extended_status_flags);
}

}  // namespace drivecodec::vlt6000
