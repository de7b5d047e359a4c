// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/word.hpp>

namespace drivecodec::vlt6000 {

/// Parameter 529: the alarms of the drive, also several at a time. VLT 6000 manual, "Warning words 1+2 and Alarm word".
///
/// The manual calls several alarms "a sum"; it is a bitwise or. Bits 29 to 31 are not in its table.
struct alarm_word : word<alarm_word, std::uint32_t> {
    static constexpr flag<alarm_word> unknown_fault{0};
    static constexpr flag<alarm_word> trip_locked{1};
    static constexpr flag<alarm_word> auto_optimisation_not_ok{2};
    /// The manual has HPFB here and HPFP at bit 6, most likely a misprint of it; which of the two a drive sets is open.
    static constexpr flag<alarm_word> hpfb_bus_timeout{3};
    static constexpr flag<alarm_word> serial_communication_timeout{4};
    static constexpr flag<alarm_word> asic_fault{5};
    static constexpr flag<alarm_word> hpfp_bus_timeout{6};
    static constexpr flag<alarm_word> standard_bus_timeout{7};
    static constexpr flag<alarm_word> short_circuiting{8};
    static constexpr flag<alarm_word> switchmode_fault{9};
    static constexpr flag<alarm_word> earth_fault{10};
    static constexpr flag<alarm_word> current_limit{11};
    static constexpr flag<alarm_word> overcurrent{12};
    static constexpr flag<alarm_word> motor_thermistor{13};
    static constexpr flag<alarm_word> motor_overheated{14};
    static constexpr flag<alarm_word> inverter_overheated{15};
    static constexpr flag<alarm_word> undervoltage{16};
    static constexpr flag<alarm_word> overvoltage{17};
    static constexpr flag<alarm_word> mains_phase_fault{18};
    static constexpr flag<alarm_word> live_zero_fault{19};
    static constexpr flag<alarm_word> heat_sink_temperature_too_high{20};
    static constexpr flag<alarm_word> motor_phase_w_missing{21};
    static constexpr flag<alarm_word> motor_phase_v_missing{22};
    static constexpr flag<alarm_word> motor_phase_u_missing{23};
    static constexpr flag<alarm_word> profibus_communication_fault{24};
    static constexpr flag<alarm_word> inverter_fault{25};
    static constexpr flag<alarm_word> output_current_low{26};
    static constexpr flag<alarm_word> safety_stop{27};
    static constexpr flag<alarm_word> reserved_28{28};
};

}  // namespace drivecodec::vlt6000
