// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::cia402 {

/// Modes of operation (6060h) and Modes of operation display (6061h). IEC 61800-7-201, "Modes of operation".
///
/// Negative numbers are the manufacturer's; what is not named here is reserved.
enum class mode_of_operation : std::int8_t {
    none                                        = 0,  ///< No change, as a command; no mode, on the display.
    profile_position                            = 1,
    velocity                                    = 2,  ///< vl, of frequency converters.
    profile_velocity                            = 3,
    profile_torque                              = 4,
    homing                                      = 6,
    interpolated_position                       = 7,
    cyclic_synchronous_position                 = 8,
    cyclic_synchronous_velocity                 = 9,
    cyclic_synchronous_torque                   = 10,
    cyclic_synchronous_torque_commutation_angle = 11,  ///< Cyclic synchronous torque with commutation angle.
};

/// Is the number one that manufacturers give a meaning to?
[[nodiscard]] constexpr bool is_manufacturer_specific(mode_of_operation mode) noexcept
{
    return static_cast<std::int8_t>(mode) < 0;
}

/// Supported drive modes (6502h): has it the bit of this mode? Bit 0 is mode 1; the manufacturer's are not told.
[[nodiscard]] constexpr bool is_supported(std::uint32_t supported_drive_modes, mode_of_operation mode) noexcept
{
    auto const number = static_cast<std::int8_t>(mode);
    return number >= 1 and number <= 16 and (supported_drive_modes >> (number - 1) & 1U) != 0;
}

}  // namespace drivecodec::cia402
