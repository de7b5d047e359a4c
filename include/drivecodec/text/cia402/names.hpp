// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/controller.hpp>
#include <drivecodec/cia402/mode_of_operation.hpp>
#include <drivecodec/cia402/mode_specific.hpp>
#include <drivecodec/cia402/transition.hpp>

#include <string_view>

// An enumerator's own name; empty for a value without one.

namespace drivecodec::cia402 {

[[nodiscard]] constexpr std::string_view to_string(state which) noexcept
{
    switch (which) {
    case state::not_ready_to_switch_on: return "not_ready_to_switch_on";
    case state::switch_on_disabled: return "switch_on_disabled";
    case state::ready_to_switch_on: return "ready_to_switch_on";
    case state::switched_on: return "switched_on";
    case state::operation_enabled: return "operation_enabled";
    case state::quick_stop_active: return "quick_stop_active";
    case state::fault_reaction_active: return "fault_reaction_active";
    case state::fault: return "fault";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(command which) noexcept
{
    switch (which) {
    case command::shutdown: return "shutdown";
    case command::switch_on: return "switch_on";
    case command::enable_operation: return "enable_operation";
    case command::disable_operation: return "disable_operation";
    case command::disable_voltage: return "disable_voltage";
    case command::quick_stop: return "quick_stop";
    case command::fault_reset: return "fault_reset";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(event which) noexcept
{
    switch (which) {
    case event::power_on: return "power_on";
    case event::initialised: return "initialised";
    case event::fault: return "fault";
    case event::fault_handled: return "fault_handled";
    case event::quick_stop_finished: return "quick_stop_finished";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(cause why) noexcept
{
    return why.is_automatic() ? to_string(why.event()) : to_string(why.command());
}

[[nodiscard]] constexpr std::string_view to_string(progress which) noexcept
{
    switch (which) {
    case progress::reached: return "reached";
    case progress::waiting: return "waiting";
    case progress::faulted: return "faulted";
    case progress::refused: return "refused";
    case progress::unreachable: return "unreachable";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(mode_of_operation which) noexcept
{
    switch (which) {
    case mode_of_operation::none: return "none";
    case mode_of_operation::profile_position: return "profile_position";
    case mode_of_operation::velocity: return "velocity";
    case mode_of_operation::profile_velocity: return "profile_velocity";
    case mode_of_operation::profile_torque: return "profile_torque";
    case mode_of_operation::homing: return "homing";
    case mode_of_operation::interpolated_position: return "interpolated_position";
    case mode_of_operation::cyclic_synchronous_position: return "cyclic_synchronous_position";
    case mode_of_operation::cyclic_synchronous_velocity: return "cyclic_synchronous_velocity";
    case mode_of_operation::cyclic_synchronous_torque: return "cyclic_synchronous_torque";
    case mode_of_operation::cyclic_synchronous_torque_commutation_angle:
        return "cyclic_synchronous_torque_commutation_angle";
    }
    return {};
}

namespace homing {
[[nodiscard]] constexpr std::string_view to_string(progress which) noexcept
{
    switch (which) {
    case progress::in_progress: return "in_progress";
    case progress::interrupted_or_not_started: return "interrupted_or_not_started";
    case progress::attained_but_target_not_reached: return "attained_but_target_not_reached";
    case progress::completed: return "completed";
    case progress::error_while_moving: return "error_while_moving";
    case progress::error_at_standstill: return "error_at_standstill";
    }
    return {};
}
}  // namespace homing

}  // namespace drivecodec::cia402
