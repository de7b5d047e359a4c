// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::smd {

/// Where the commanded speed is from: the high byte of register 28. smd manual, table 14, "Speed command source".
enum class speed_source : std::uint8_t {
    analog     = 0,
    preset_c40 = 1,
    preset_1   = 2,  ///< C37.
    preset_2   = 3,  ///< C38.
    preset_3   = 4,  ///< C39.
    mop        = 5,  ///< Motor potentiometer: the digital inputs "up" and "down".
    serial     = 6,  ///< Register 40.
};

/// Which reference was chosen, by the commands of the same names: the low byte of register 28. smd manual, table 15,
/// "Speed reference status".
enum class speed_reference : std::uint8_t { serial = 0, local = 1 };

}  // namespace drivecodec::smd
