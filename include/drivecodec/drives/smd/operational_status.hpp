// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::smd {

/// What the drive is doing: the low byte of register 26. smd manual, tables 11 and 20.
///
/// A number, one state at a time. Both tables head it "Bit", up to 13, which a byte does not have; section 7.4 says that
/// the value of the byte is the state.
enum class operational_status : std::uint8_t {
    fault_lockout                  = 0,
    fault                          = 1,
    start_pending                  = 2,
    stop                           = 3,
    dc_brake                       = 4,
    run_at_0_hz                    = 5,
    run                            = 6,
    accel                          = 7,
    decel                          = 8,
    current_limit                  = 9,
    decel_override                 = 10,
    lower_transistors_switching_on = 11,
    off                            = 12,
    inhibit                        = 13,
};

}  // namespace drivecodec::smd
