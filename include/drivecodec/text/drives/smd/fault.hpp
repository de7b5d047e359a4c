// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/fault.hpp>
#include <drivecodec/text/drives/code.hpp>

namespace drivecodec::smd {

/// An enumerator's own name; empty for a value without one.
[[nodiscard]] constexpr std::string_view to_string(fault code) noexcept
{
    switch (code) {
    case fault::no_fault: return "no_fault";
    case fault::output_transistor_fault: return "output_transistor_fault";
    case fault::high_drive_temperature: return "high_drive_temperature";
    case fault::high_dc_bus_voltage: return "high_dc_bus_voltage";
    case fault::low_dc_bus_voltage: return "low_dc_bus_voltage";
    case fault::thermal_overload: return "thermal_overload";
    case fault::control_fault: return "control_fault";
    case fault::external_fault: return "external_fault";
    case fault::serial_communication_failure: return "serial_communication_failure";
    case fault::start_error: return "start_error";
    case fault::internal_fault_1_epm: return "internal_fault_1_epm";
    case fault::internal_fault_2: return "internal_fault_2";
    case fault::internal_fault_3: return "internal_fault_3";
    case fault::internal_fault_4: return "internal_fault_4";
    case fault::internal_fault_5: return "internal_fault_5";
    case fault::internal_fault_6: return "internal_fault_6";
    case fault::internal_fault_7: return "internal_fault_7";
    case fault::internal_fault_8: return "internal_fault_8";
    case fault::internal_fault_9: return "internal_fault_9";
    case fault::internal_fault_o: return "internal_fault_o";
    case fault::single_phase_fault: return "single_phase_fault";
    case fault::incompatibility_fault: return "incompatibility_fault";
    case fault::dynamic_brake_overheated: return "dynamic_brake_overheated";
    case fault::remote_keypad_fault: return "remote_keypad_fault";
    case fault::communication_fault: return "communication_fault";
    case fault::earth_fault: return "earth_fault";
    case fault::configuration_fault: return "configuration_fault";
    }
    return {};
}

/// What the drive's display shows. Empty for no fault, and for a code that the manual does not have. Upper and lower case
/// differ: CF is a control fault, cF an incompatibility.
[[nodiscard]] constexpr std::string_view display_text(fault code) noexcept
{
    switch (code) {
    case fault::no_fault: return {};
    case fault::output_transistor_fault: return "OC1";
    case fault::high_drive_temperature: return "OH";
    case fault::high_dc_bus_voltage: return "OU";
    case fault::low_dc_bus_voltage: return "LU";
    case fault::thermal_overload: return "OC6";
    case fault::control_fault: return "CF";
    case fault::external_fault: return "EEr";
    case fault::serial_communication_failure: return "FC5";
    case fault::start_error: return "LC";
    case fault::internal_fault_1_epm: return "F1";
    case fault::internal_fault_2: return "F2";
    case fault::internal_fault_3: return "F3";
    case fault::internal_fault_4: return "F4";
    case fault::internal_fault_5: return "F5";
    case fault::internal_fault_6: return "F6";
    case fault::internal_fault_7: return "F7";
    case fault::internal_fault_8: return "F8";
    case fault::internal_fault_9: return "F9";
    case fault::internal_fault_o: return "Fo";
    case fault::single_phase_fault: return "SF";
    case fault::incompatibility_fault: return "cF";
    case fault::dynamic_brake_overheated: return "dF";
    case fault::remote_keypad_fault: return "JF";
    case fault::communication_fault: return "FC3";
    case fault::earth_fault: return "OC2";
    case fault::configuration_fault: return "CFG";
    }
    return {};
}

/// `communication_fault 24 FC3`, `no_fault`; of a code that the manual does not have, `fault 27`.
constexpr void write_text(text_writer& out, fault code) noexcept
{
    if (code == fault::no_fault) {
        out.put(to_string(code));
        return;
    }
    auto const name = to_string(code);
    out.put(name.empty() ? "fault" : name).put(' ').decimal(static_cast<std::uint16_t>(code));
    if (auto const shown = display_text(code); not shown.empty()) { out.put(' ').put(shown); }
}

}  // namespace drivecodec::smd
