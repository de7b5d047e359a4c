// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/word.hpp>

namespace drivecodec::vlt6000 {

/// Parameter 531: the warnings of the drive, also several at a time. VLT 6000 manual, "Warning words 1+2 and Alarm
/// word".
///
/// That heading promises two warning words; there is one. It calls several warnings "a sum"; it is a bitwise or.
struct warning_word : word<warning_word, std::uint32_t> {
    static constexpr flag<warning_word> reference_high{0};
    static constexpr flag<warning_word> fault_in_eeprom_on_control_card{1};
    static constexpr flag<warning_word> fault_in_eeprom_on_power_card{2};
    static constexpr flag<warning_word> hpfb_bus_timeout{3};
    static constexpr flag<warning_word> serial_communication_timeout{4};
    static constexpr flag<warning_word> overcurrent{5};
    static constexpr flag<warning_word> current_limit{6};
    static constexpr flag<warning_word> motor_thermistor{7};
    static constexpr flag<warning_word> motor_overtemperature{8};
    static constexpr flag<warning_word> inverter_overtemperature{9};
    static constexpr flag<warning_word> undervoltage{10};
    static constexpr flag<warning_word> overvoltage{11};
    static constexpr flag<warning_word> voltage_warning_low{12};
    static constexpr flag<warning_word> voltage_warning_high{13};
    static constexpr flag<warning_word> mains_phase_fault{14};
    static constexpr flag<warning_word> live_zero_fault{15};
    static constexpr flag<warning_word> under_10_volt{16};  ///< At terminal 50.
    static constexpr flag<warning_word> reference_low{17};
    static constexpr flag<warning_word> feedback_high{18};
    static constexpr flag<warning_word> feedback_low{19};
    static constexpr flag<warning_word> output_current_high{20};
    static constexpr flag<warning_word> out_of_frequency_range{21};
    static constexpr flag<warning_word> profibus_communication_fault{22};
    static constexpr flag<warning_word> output_current_low{23};
    static constexpr flag<warning_word> output_frequency_high{24};
    static constexpr flag<warning_word> output_frequency_low{25};
    static constexpr flag<warning_word> ama_motor_too_small{26};  ///< AMA: automatic motor adaptation.
    static constexpr flag<warning_word> ama_motor_too_big{27};
    static constexpr flag<warning_word> ama_check_parameters_102_103_105{28};
    static constexpr flag<warning_word> ama_check_parameters_102_104_106{29};
    static constexpr flag<warning_word> reserved_30{30};
    static constexpr flag<warning_word> reserved_31{31};
};

}  // namespace drivecodec::vlt6000
