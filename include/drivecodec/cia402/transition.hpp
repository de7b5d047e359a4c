// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/command.hpp>

#include <initializer_list>

namespace drivecodec::cia402 {

/// What happens to a drive without a command.
enum class event : std::uint8_t {
    power_on,
    initialised,          ///< The self-test and the initialisation are done.
    fault,                ///< Detected.
    fault_handled,        ///< The reaction to it is done: the motor is without power.
    quick_stop_finished,  ///< The motor stands.
};

/// Why a state changes: a command, or an event, upon which the drive changes it by itself.
class cause {
public:
    constexpr cause(cia402::command given) noexcept : packed_{static_cast<std::uint8_t>(given)} {}
    constexpr cause(cia402::event happened) noexcept
        : packed_{static_cast<std::uint8_t>(first_event + static_cast<unsigned>(happened))}
    {}

    [[nodiscard]] constexpr bool is_automatic() const noexcept { return packed_ >= first_event; }

    /// Precondition: not is_automatic().
    [[nodiscard]] constexpr cia402::command command() const noexcept { return static_cast<cia402::command>(packed_); }
    /// Precondition: is_automatic().
    [[nodiscard]] constexpr cia402::event event() const noexcept
    {
        return static_cast<cia402::event>(packed_ - first_event);
    }

    friend constexpr bool operator==(cause, cause) noexcept = default;

private:
    static constexpr unsigned first_event = command_count;

    std::uint8_t packed_;
};

/// Some of the states.
class state_set {
public:
    constexpr state_set() noexcept = default;
    constexpr state_set(state only) noexcept : bits_{static_cast<std::uint8_t>(bit(only))} {}
    constexpr state_set(std::initializer_list<state> states) noexcept
    {
        for (auto const each : states) { bits_ = static_cast<std::uint8_t>(bits_ | bit(each)); }
    }

    [[nodiscard]] constexpr bool contains(state which) const noexcept { return (bits_ & bit(which)) != 0; }
    [[nodiscard]] constexpr bool empty() const noexcept { return bits_ == 0; }

    friend constexpr bool operator==(state_set, state_set) noexcept = default;

private:
    [[nodiscard]] static constexpr unsigned bit(state which) noexcept { return 1U << static_cast<unsigned>(which); }

    std::uint8_t bits_ = 0;
};

/// What a transition out of Quick stop active asks of the quick stop option code (605Ah).
enum class quick_stop_condition : std::uint8_t {
    none,
    leaves,  ///< A code with which the drive leaves the state when it stands: 1 to 4.
    stays,   ///< A code with which it stays in the state: 5 to 8.
};

struct transition {
    std::uint8_t         number;
    state_set            from;  ///< Empty: the drive was without power.
    state                to;
    cia402::cause        cause;
    quick_stop_condition condition = quick_stop_condition::none;
};

/// IEC 61800-7-201, "Transition events and actions". What two commands cause has two rows.
///
/// Enable operation causes 3 too, and 4 follows at once: 000Fh leads straight from Ready to switch on to Operation
/// enabled.
///
/// The array's type is written out: g++ 12 puts a deduced one into RAM.
// clang-format off
inline constexpr std::array<transition, 21> transitions{{
    transition{0,  {},                            state::not_ready_to_switch_on, event::power_on},
    transition{1,  state::not_ready_to_switch_on, state::switch_on_disabled,     event::initialised},
    transition{2,  state::switch_on_disabled,     state::ready_to_switch_on,     command::shutdown},
    transition{3,  state::ready_to_switch_on,     state::switched_on,            command::switch_on},
    transition{3,  state::ready_to_switch_on,     state::switched_on,            command::enable_operation},
    transition{4,  state::switched_on,            state::operation_enabled,      command::enable_operation},
    transition{5,  state::operation_enabled,      state::switched_on,            command::disable_operation},
    transition{6,  state::switched_on,            state::ready_to_switch_on,     command::shutdown},
    transition{7,  state::ready_to_switch_on,     state::switch_on_disabled,     command::disable_voltage},
    transition{7,  state::ready_to_switch_on,     state::switch_on_disabled,     command::quick_stop},
    transition{8,  state::operation_enabled,      state::ready_to_switch_on,     command::shutdown},
    transition{9,  state::operation_enabled,      state::switch_on_disabled,     command::disable_voltage},
    transition{10, state::switched_on,            state::switch_on_disabled,     command::disable_voltage},
    transition{10, state::switched_on,            state::switch_on_disabled,     command::quick_stop},
    transition{11, state::operation_enabled,      state::quick_stop_active,      command::quick_stop},
    transition{12, state::quick_stop_active,      state::switch_on_disabled,     command::disable_voltage},
    transition{12, state::quick_stop_active,      state::switch_on_disabled,     event::quick_stop_finished,
               quick_stop_condition::leaves},
    transition{13, {state::not_ready_to_switch_on, state::switch_on_disabled, state::ready_to_switch_on,
                    state::switched_on, state::operation_enabled, state::quick_stop_active},
                                                  state::fault_reaction_active,  event::fault},
    transition{14, state::fault_reaction_active,  state::fault,                  event::fault_handled},
    transition{15, state::fault,                  state::switch_on_disabled,     command::fault_reset},
    transition{16, state::quick_stop_active,      state::operation_enabled,      command::enable_operation,
               quick_stop_condition::stays},
}};
// clang-format on

/// The transition out of `from` that `why` causes, or nullptr if it causes none.
[[nodiscard]] constexpr transition const* find_transition(state from, cause why) noexcept
{
    for (auto const& row : transitions) {
        if (row.from.contains(from) and row.cause == why) { return &row; }
    }
    return nullptr;
}

}  // namespace drivecodec::cia402
