// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// What a drive does at a stop: objects 605Ah to 605Eh. IEC 61800-7-201, "Option codes". Negative numbers are the
// manufacturer's; what is not named here is reserved.

namespace drivecodec::cia402 {

/// 605Ah. After 1 to 4 the drive goes to Switch on disabled; with 5 to 8 it stays in Quick stop active.
enum class quick_stop_option : std::int16_t {
    disable_drive            = 0,
    slow_down_ramp           = 1,
    quick_stop_ramp          = 2,
    current_limit            = 3,
    voltage_limit            = 4,
    slow_down_ramp_and_stay  = 5,
    quick_stop_ramp_and_stay = 6,
    current_limit_and_stay   = 7,
    voltage_limit_and_stay   = 8,
};

/// Does the drive stay in Quick stop active when the motor stands? Of a manufacturer's code nothing is known: false.
[[nodiscard]] constexpr bool stays_in_quick_stop(quick_stop_option code) noexcept
{
    return code >= quick_stop_option::slow_down_ramp_and_stay and code <= quick_stop_option::voltage_limit_and_stay;
}

/// 605Bh, transition 8: from Operation enabled to Ready to switch on.
enum class shutdown_option : std::int16_t {
    disable_drive  = 0,
    slow_down_ramp = 1,
};

/// 605Ch, transition 5: from Operation enabled to Switched on.
enum class disable_operation_option : std::int16_t {
    disable_drive  = 0,
    slow_down_ramp = 1,
};

/// 605Dh, the halt bit: the drive stays in Operation enabled.
enum class halt_option : std::int16_t {
    slow_down_ramp  = 1,
    quick_stop_ramp = 2,
    current_limit   = 3,
    voltage_limit   = 4,
};

/// 605Eh, transitions 13 and 14.
enum class fault_reaction_option : std::int16_t {
    disable_drive   = 0,
    slow_down_ramp  = 1,
    quick_stop_ramp = 2,
    current_limit   = 3,
    voltage_limit   = 4,
};

}  // namespace drivecodec::cia402
