// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/transition.hpp>

namespace drivecodec::cia402 {

/// What a drive offers, and what its user wants, on the way to Operation enabled.
struct way {
    /// The drive offers transition 16: from Quick stop active back to Operation enabled.
    bool resumes_from_quick_stop = false;
    /// 000Fh straight from Ready to switch on: transitions 3 and 4 by one command.
    bool straight_to_operation_enabled = false;
};

/// What to do next on the way to a goal: give a command, or what there is instead of one.
class step {
public:
    static step const reached;      ///< Nothing: this is the goal.
    static step const wait;         ///< Nothing: the drive goes on by itself.
    static step const unreachable;  ///< No command leads there from here.

    constexpr step(cia402::command given) noexcept : packed_{static_cast<std::uint8_t>(given)} {}

    [[nodiscard]] constexpr bool is_command() const noexcept { return packed_ < command_count; }
    /// Precondition: is_command().
    [[nodiscard]] constexpr cia402::command command() const noexcept { return static_cast<cia402::command>(packed_); }

    friend constexpr bool operator==(step, step) noexcept = default;

private:
    enum class no_command : std::uint8_t { reached = command_count, wait, unreachable };
    constexpr explicit step(no_command what) noexcept : packed_{static_cast<std::uint8_t>(what)} {}

    std::uint8_t packed_;
};
inline constexpr step step::reached{no_command::reached};
inline constexpr step step::wait{no_command::wait};
inline constexpr step step::unreachable{no_command::unreachable};

/// Can `goal` be commanded? Neither the faults nor the state after power-on can.
[[nodiscard]] constexpr bool is_goal(state goal) noexcept
{
    return goal >= state::switch_on_disabled and goal <= state::quick_stop_active;
}

namespace detail {

/// By goal, from Switch on disabled. The type is written out: g++ 12 puts a deduced array into RAM.
inline constexpr std::array<command, 5> holding_commands{
    {command::disable_voltage, command::shutdown, command::switch_on, command::enable_operation, command::quick_stop}};

/// In these a drive goes on by itself.
inline constexpr state_set transient_states{state::not_ready_to_switch_on, state::fault_reaction_active};

}  // namespace detail

/// The command that leads down to `goal`, and that a drive in it is to be given to stay there. Precondition:
/// is_goal(goal).
[[nodiscard]] constexpr command holding_command(state goal) noexcept
{
    return detail::holding_commands[static_cast<std::size_t>(goal)
                                    - static_cast<std::size_t>(state::switch_on_disabled)];
}

/// The next step on the shortest way from `from` to `goal`, counted in transitions.
///
/// Goals are Switch on disabled, Ready to switch on, Switched on, Operation enabled and, from there only, Quick stop
/// active; all else is `unreachable`. No way goes through Operation enabled, where the motor may turn, to another goal.
/// Out of Quick stop active the way is transition 12, Disable voltage, which ends the ramp; to Operation enabled it is
/// 16, if the drive offers that. Out of Fault it is the reset, which must be an edge: see `controller`.
[[nodiscard]] constexpr step next(state from, state goal, way chosen = {}) noexcept
{
    if (not is_goal(goal)) { return step::unreachable; }
    if (from == goal) { return step::reached; }
    if (goal == state::quick_stop_active) {
        return from == state::operation_enabled ? step{command::quick_stop} : step::unreachable;
    }
    if (detail::transient_states.contains(from)) { return step::wait; }
    if (from == state::fault) { return command::fault_reset; }
    if (from == state::operation_enabled and goal == state::switched_on) { return command::disable_operation; }

    // In the order of the enumeration: down to any state at once, upwards one at a time.
    auto to = goal;
    if (from == state::quick_stop_active) {
        if (goal != state::operation_enabled or not chosen.resumes_from_quick_stop) { to = state::switch_on_disabled; }
    } else if (goal > from and not(chosen.straight_to_operation_enabled and from == state::ready_to_switch_on)) {
        to = static_cast<state>(static_cast<unsigned>(from) + 1);
    }
    return holding_command(to);
}

}  // namespace drivecodec::cia402
