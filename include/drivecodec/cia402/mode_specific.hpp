// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/control_word.hpp>
#include <drivecodec/cia402/status_word.hpp>
#include <drivecodec/core/result.hpp>

// What bits 4 to 6 and 9 of the controlword and 10, 12 and 13 of the statusword mean in each mode of operation:
//
//     word = word.with(profile_position::new_set_point);
//     if (status.test(profile_position::set_point_acknowledge)) ...
//
// IEC 61800-7-201, in the clause of each mode, "Use of controlword and statusword". Names say what a 1 means.

namespace drivecodec::cia402 {

namespace profile_position {
inline constexpr flag<control_word> new_set_point{4};           ///< Acts when it changes from 0 to 1.
inline constexpr flag<control_word> change_set_immediately{5};  ///< 0: when the present positioning is done.
inline constexpr flag<control_word> relative{6};                ///< Target position is relative; 0: absolute.
inline constexpr flag<control_word> change_on_set_point{9};     ///< Passes the present one without a stop.
inline constexpr flag<status_word>  target_reached{10};         ///< With halt: the velocity is zero.
inline constexpr flag<status_word>  set_point_acknowledge{12};  ///< The set-point was taken; 0: one may be given.
inline constexpr flag<status_word>  following_error{13};
}  // namespace profile_position

/// vl. Without these three the motor stands still or keeps its speed, as the drive's profile says.
namespace velocity {
inline constexpr flag<control_word> enable_ramp{4};     ///< The motor follows the ramp's output.
inline constexpr flag<control_word> unlock_ramp{5};     ///< The ramp's output follows its input; 0: it is frozen.
inline constexpr flag<control_word> reference_ramp{6};  ///< The ramp's input is the reference; 0: it is zero.
}  // namespace velocity

namespace profile_velocity {
inline constexpr flag<status_word> target_reached{10};  ///< With halt: the velocity is zero.
inline constexpr flag<status_word> speed_is_zero{12};
inline constexpr flag<status_word> maximum_slippage_error{13};
}  // namespace profile_velocity

namespace profile_torque {
inline constexpr flag<status_word> target_reached{10};  ///< With halt: the velocity is zero.
}  // namespace profile_torque

namespace homing {
inline constexpr flag<control_word> start{4};
inline constexpr flag<status_word>  target_reached{10};
inline constexpr flag<status_word>  attained{12};
inline constexpr flag<status_word>  error{13};

/// Bits 13, 12 and 10 together.
enum class progress : std::uint8_t {
    in_progress                     = 0b000,
    interrupted_or_not_started      = 0b001,
    attained_but_target_not_reached = 0b010,
    completed                       = 0b011,
    error_while_moving              = 0b100,
    error_at_standstill             = 0b101,
};

/// How far the homing is. Errors: `bad_value` at 0 for the two combinations that the standard reserves.
[[nodiscard]] constexpr result<progress> decode_progress(status_word status) noexcept
{
    auto const bits =
        (status.test(error) ? 4U : 0U) | (status.test(attained) ? 2U : 0U) | (status.test(target_reached) ? 1U : 0U);
    if (bits > static_cast<unsigned>(progress::error_at_standstill)) { return drivecodec::error{errc::bad_value, 0}; }
    return static_cast<progress>(bits);
}
}  // namespace homing

namespace interpolated_position {
inline constexpr flag<control_word> enable_interpolation{4};
inline constexpr flag<status_word>  target_reached{10};
inline constexpr flag<status_word>  active{12};  ///< The drive interpolates.
}  // namespace interpolated_position

namespace cyclic_synchronous_position {
inline constexpr flag<status_word> follows_command{12};  ///< 0: target position is ignored.
inline constexpr flag<status_word> following_error{13};
}  // namespace cyclic_synchronous_position

namespace cyclic_synchronous_velocity {
inline constexpr flag<status_word> follows_command{12};  ///< 0: target velocity is ignored.
}  // namespace cyclic_synchronous_velocity

namespace cyclic_synchronous_torque {
inline constexpr flag<status_word> follows_command{12};  ///< 0: target torque is ignored.
}  // namespace cyclic_synchronous_torque

}  // namespace drivecodec::cia402
