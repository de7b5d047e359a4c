// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// What two bits choose of four. VLT 6000 manual, "Control word as per FC protocol".
//
// A value is what the bits hold, 2 msb + lsb; the manual's number is one more: two bits that are 1 choose number 4.

namespace drivecodec::vlt6000 {

/// Bits 00/01 of the control word: the reference of parameter 211, 212, 213 or 214.
enum class preset_reference : std::uint8_t {
    preset_reference_1 = 0,
    preset_reference_2 = 1,
    preset_reference_3 = 2,
    preset_reference_4 = 3,
};

/// Bits 13/14 of the control word: one of the four menu setups, if parameter 004 is multi-setup.
enum class setup : std::uint8_t {
    setup_1 = 0,
    setup_2 = 1,
    setup_3 = 2,
    setup_4 = 3,
};

/// The manual's number, 1 to 4.
[[nodiscard]] constexpr std::uint8_t number(preset_reference chosen) noexcept
{
    return static_cast<std::uint8_t>(static_cast<unsigned>(chosen) + 1);
}
[[nodiscard]] constexpr std::uint8_t number(setup chosen) noexcept
{
    return static_cast<std::uint8_t>(static_cast<unsigned>(chosen) + 1);
}

}  // namespace drivecodec::vlt6000
