// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::drives {

/// What the serial line may do with a register or parameter, as far as the drive's manual says it.
enum class access : std::uint8_t {
    unknown,                   ///< The manual names it, and no more. The drive knows.
    read_only,                 ///< Read out: to a write, expect a refusal.
    read_write,                ///< A setting, or what is there to command the drive.
    read_write_at_standstill,  ///< Refused while the motor has power.
    write_only,                ///< It is there to be written. No manual says that it can be read, some that it cannot.
    panel_only,                ///< Set at the drive's own panel alone: to a write, expect a refusal.
};

/// False only of what is there to be written.
[[nodiscard]] constexpr bool is_readable(access may) noexcept
{
    return may != access::write_only;
}

/// False only if the manual says no. Of what is unknown, the drive's reply tells.
[[nodiscard]] constexpr bool is_writable(access may) noexcept
{
    return may != access::read_only and may != access::panel_only;
}

}  // namespace drivecodec::drives
