// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/transition.hpp>

namespace drivecodec::cia402 {

/// The drive's side: controlwords and events in, state and statusword out. For drives, simulators and tests.
class machine {
public:
    struct settings {
        /// The quick stop option code (605Ah) is one of 5 to 8: the drive stays in Quick stop active when it stands.
        bool stays_in_quick_stop = true;
        /// Transition 16, which only such a code allows: Enable operation leads from Quick stop active back.
        bool resumes_from_quick_stop = false;
    };

    /// Powered, Not ready to switch on.
    constexpr machine() noexcept = default;
    constexpr explicit machine(settings chosen) noexcept : settings_{chosen} {}

    [[nodiscard]] constexpr cia402::state state() const noexcept { return state_; }

    /// The state's coding and Voltage enabled; all other bits are 0, for the caller to add.
    ///
    /// In the faults the quick stop bit tells whether the fault came in Quick stop active (0), as drives do in which it
    /// is not just anything.
    [[nodiscard]] constexpr status_word status() const noexcept
    {
        auto const coding = state_codings[static_cast<std::size_t>(state_)].low_byte;
        auto       status = status_word::from_raw(coding.value);
        if (has_voltage_) { status = status.with(status_word::voltage_enabled); }
        if (is_faulty() and not was_quick_stop_) { status = status.with(status_word::no_quick_stop); }
        return status;
    }

    /// The control word that arrived, once for each time that it arrives.
    ///
    /// In Fault a rising reset bit is a reset, and the word nothing else. Every other word is the command that its
    /// level tells, carried out as far as it goes: 000Fh leads through Switched on. What is no transition from here
    /// changes nothing.
    constexpr void receive(control_word word) noexcept
    {
        auto const had_reset = has_reset_;
        has_reset_           = word.test(control_word::fault_reset);
        if (has_reset_ and not had_reset and state_ == state::fault) {
            static_cast<void>(take(command::fault_reset));
            return;
        }
        while (take(decode_command(word, state_))) {}
    }

    //=== events ===//

    constexpr void initialised() noexcept { static_cast<void>(take(event::initialised)); }
    constexpr void fault() noexcept { static_cast<void>(take(event::fault)); }
    constexpr void fault_handled() noexcept { static_cast<void>(take(event::fault_handled)); }
    constexpr void quick_stop_finished() noexcept { static_cast<void>(take(event::quick_stop_finished)); }

    /// The power stage is no longer supplied: as Disable voltage, in the states that need it. Transition 3 needs it
    /// too.
    constexpr void voltage_lost() noexcept
    {
        has_voltage_ = false;
        if (state_ != state::ready_to_switch_on) { static_cast<void>(take(command::disable_voltage)); }
    }
    constexpr void voltage_restored() noexcept { has_voltage_ = true; }

private:
    [[nodiscard]] constexpr bool take(cause why) noexcept
    {
        auto const* row = find_transition(state_, why);
        if (row == nullptr or not is_offered(*row)) { return false; }
        if (row->to == state::fault_reaction_active) { was_quick_stop_ = state_ == state::quick_stop_active; }
        state_ = row->to;
        return true;
    }

    [[nodiscard]] constexpr bool is_offered(transition const& row) const noexcept
    {
        switch (row.condition) {
        case quick_stop_condition::leaves: return not settings_.stays_in_quick_stop;
        case quick_stop_condition::stays: return settings_.stays_in_quick_stop and settings_.resumes_from_quick_stop;
        case quick_stop_condition::none: break;
        }
        return has_voltage_ or row.to != state::switched_on;
    }

    [[nodiscard]] constexpr bool is_faulty() const noexcept
    {
        return state_ == state::fault_reaction_active or state_ == state::fault;
    }

    settings      settings_{};
    cia402::state state_          = cia402::state::not_ready_to_switch_on;
    bool          has_voltage_    = true;
    bool          has_reset_      = false;  // in the last control word
    bool          was_quick_stop_ = false;  // when the fault came
};

}  // namespace drivecodec::cia402
