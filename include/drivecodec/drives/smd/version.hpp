// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

namespace drivecodec::smd {

/// Which registers the parameters have, by the number in register 50; also called parameter configuration. smd manual,
/// sections 3.3 and 6.1.
///
/// From register 71 on, the same number means different parameters in the two: whoever writes knows the version, or has
/// read register 50.
enum class version : std::uint16_t {
    pv400 = 400,  ///< Software 1.51.
    pv507 = 507,  ///< Software 2.00 and 2.01.
};
using enum version;

/// Of what stands in register 50. Errors: `bad_value` at 0 for any other number: the manual does not have the registers
/// of that drive, and "writing to any register on the drive must not be attempted".
[[nodiscard]] constexpr result<version> make_version(std::uint16_t register_50) noexcept
{
    auto const number = static_cast<version>(register_50);
    if (number != pv400 and number != pv507) { return error{errc::bad_value, 0}; }
    return number;
}

}  // namespace drivecodec::smd
