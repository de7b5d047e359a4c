// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::smd {

/// The high byte of register 29, and parameters c61 to c63. smd manual, tables 16 and 18.
///
/// c61 is also said to show "Inh" or "Stp" after a serial time-out: those are texts of the display without a code.
enum class fault : std::uint16_t {
    no_fault                     = 0,
    output_transistor_fault      = 1,   ///< OC1
    high_drive_temperature       = 2,   ///< OH
    high_dc_bus_voltage          = 3,   ///< OU
    low_dc_bus_voltage           = 4,   ///< LU
    thermal_overload             = 5,   ///< OC6
    control_fault                = 6,   ///< CF
    external_fault               = 7,   ///< EEr
    serial_communication_failure = 8,   ///< FC5. What raises it is not stated.
    start_error                  = 9,   ///< LC
    internal_fault_1_epm         = 10,  ///< F1
    internal_fault_2             = 11,  ///< F2
    internal_fault_3             = 12,  ///< F3
    internal_fault_4             = 13,  ///< F4
    internal_fault_5             = 14,  ///< F5
    internal_fault_6             = 15,  ///< F6
    internal_fault_7             = 16,  ///< F7
    internal_fault_8             = 17,  ///< F8
    internal_fault_9             = 18,  ///< F9
    internal_fault_o             = 19,  ///< Fo, a letter.
    single_phase_fault           = 20,  ///< SF
    incompatibility_fault        = 21,  ///< cF, another than CF.
    dynamic_brake_overheated     = 22,  ///< dF
    remote_keypad_fault          = 23,  ///< JF
    communication_fault          = 24,  ///< FC3: a serial time-out, if n22 is 3.
    earth_fault                  = 25,  ///< OC2
    configuration_fault          = 26,  ///< CFG
};

[[nodiscard]] constexpr bool is_communication(fault code) noexcept
{
    return code == fault::serial_communication_failure or code == fault::communication_fault;
}

}  // namespace drivecodec::smd
