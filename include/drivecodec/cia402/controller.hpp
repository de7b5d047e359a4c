// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/next.hpp>

namespace drivecodec::cia402 {

/// What a controller says of its drive.
enum class progress : std::uint8_t {
    reached,  ///< The drive is in the goal; `word()` keeps it there.
    waiting,  ///< On the way.
    faulted,  ///< The drive is in Fault, and stays there until `reset_fault`.
    refused,  ///< The drive did not follow within the given number of statuswords.
    /// No command leads to the goal from here; `word()` keeps the drive where it is. Also said of Quick stop active
    /// once the drive has left it by itself, as it does with the quick stop option codes 1 to 4.
    unreachable,
};

/// The client's side: takes a drive to a state and keeps it there, over whatever bus.
///
/// It is fed every statusword and says which controlword to send next; it neither sends nor waits. To leave the goal
/// again, or to stay down after the drive has left it by itself, one sets another one.
class controller {
public:
    struct settings {
        cia402::way way{};
        /// How many statuswords in a row may show no new state before the drive is said to have refused. No more than
        /// 8 * (patience + 1) + 1 of them are ever answered by `waiting`.
        std::uint16_t patience = 10;
    };

    /// The goal is Switch on disabled.
    constexpr controller() noexcept = default;
    constexpr explicit controller(settings chosen) noexcept : settings_{chosen} {}

    /// At once, `word()` no longer enables operation unless that is the goal: the last such word may have been lost,
    /// and the next statusword may not tell where the drive is.
    constexpr void set_goal(state goal) noexcept
    {
        goal_ = goal;
        start_again();
        if (word_.test(control_word::enable_operation) and is_goal(goal) and goal != state::operation_enabled) {
            give(holding_command(goal));
        }
    }
    [[nodiscard]] constexpr state goal() const noexcept { return goal_; }

    /// The bits that no command uses, for every word from now on: halt, those of the mode, those of the manufacturer.
    constexpr void set_other_bits(control_word others) noexcept
    {
        word_.raw = static_cast<std::uint16_t>((word_.raw & command_bits) | (others.raw & ~command_bits));
    }

    /// Leave to reset one fault: the present one, or that whose reaction goes on. What follows then is the way to the
    /// goal; whoever wants to look first sets Switch on disabled as the goal before.
    constexpr void reset_fault() noexcept
    {
        reset_ = reset::granted;
        start_again();
    }

    /// The drive has said this. What it means to the goal; `word()` is what to send next.
    constexpr progress update(status_word heard) noexcept
    {
        word_ = word_.without(control_word::fault_reset);

        auto const decoded = decode_state(heard);
        if (not decoded) { return wait(); }
        auto const present = *decoded;
        if ((seen_ & bit(present)) == 0) {
            seen_ = static_cast<std::uint8_t>(seen_ | bit(present));
            left_ = std::uint32_t{settings_.patience} + 1;  // and this word, which is new
        }
        if (present == state::fault) { return in_fault(); }
        if (present != state::fault_reaction_active) { reset_ = reset::none; }

        auto const now = next(present, goal_, settings_.way);
        if (now == step::wait) { return wait(); }
        if (now.is_command()) {
            give(now.command());
            return wait();
        }
        if (is_goal(present)) { give(holding_command(present)); }  // else an earlier command would go on
        if (now == step::unreachable) { return progress::unreachable; }
        start_again();
        return progress::reached;
    }

    /// The controlword to send. Before the first statusword it commands nothing: Disable voltage.
    [[nodiscard]] constexpr control_word word() const noexcept { return word_; }

private:
    /// The reset is an edge: one word with the bit low, one with it high, and then low again.
    enum class reset : std::uint8_t { none, granted, lowered, raised };

    constexpr progress in_fault() noexcept
    {
        give(command::disable_voltage);  // nothing to be switched on by the reset; lowers its bit
        if (reset_ == reset::raised) {
            if (wait() == progress::waiting) { return progress::waiting; }
            reset_ = reset::none;
        }
        if (reset_ == reset::none) { return progress::faulted; }
        if (reset_ == reset::lowered) { give(command::fault_reset); }
        reset_ = reset_ == reset::granted ? reset::lowered : reset::raised;
        return progress::waiting;
    }

    constexpr progress wait() noexcept
    {
        if (left_ == 0) { return progress::refused; }
        --left_;
        return progress::waiting;
    }

    /// The command with 0 in the bits that do not matter to it: the words that manuals print.
    constexpr void give(command given) noexcept
    {
        auto const bits = command_codings[static_cast<std::size_t>(given)].value;
        word_.raw       = static_cast<std::uint16_t>((word_.raw & ~command_bits) | bits);
    }

    constexpr void start_again() noexcept
    {
        seen_ = 0;
        left_ = settings_.patience;
    }

    [[nodiscard]] static constexpr unsigned bit(state which) noexcept { return 1U << static_cast<unsigned>(which); }

    settings      settings_{};
    control_word  word_{};
    std::uint32_t left_  = settings_.patience;  // how many statuswords may still show no state that is new
    std::uint8_t  seen_  = 0;  // the states since the goal was set or reached; each new one is a sign of life
    state         goal_  = state::switch_on_disabled;
    reset         reset_ = reset::none;
};

}  // namespace drivecodec::cia402
