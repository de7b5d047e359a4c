// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/link.hpp>
#include <drivecodec/drives/smd/locks.hpp>

// The serial link watchdog: what it does in the drive, and what a master does against it. smd manual, section 4.4.

namespace drivecodec::smd {

/// What the drive does when nobody has talked to it for longer than n23.
enum class time_out_reaction : std::uint8_t {
    none,              ///< No time-out.
    lock,              ///< Ends the permission to write, and goes on: only parameters were unlocked.
    lock_and_inhibit,  ///< Coasts to a stop; the status display says "Inh".
    lock_and_stop,     ///< Ramps to a stop; the status display says "Stp".
    lock_and_trip,     ///< Trips: fault FC3, which is 24.
};

/// Of a time-out in this state. `none` where the watchdog does not run: nothing is unlocked, or n22 is 0; also for an n22
/// that is unknown.
[[nodiscard]] constexpr time_out_reaction reaction_to_time_out(serial_timeout_action n22, lock_state state) noexcept
{
    auto const number = static_cast<unsigned>(n22);
    if (number == 0 or number > 3 or state == lock_state::locked) { return time_out_reaction::none; }
    if (state == lock_state::parameters) { return time_out_reaction::lock; }
    switch (n22) {
    case serial_timeout_action::controller_inhibit: return time_out_reaction::lock_and_inhibit;
    case serial_timeout_action::quick_stop: return time_out_reaction::lock_and_stop;
    default: return time_out_reaction::lock_and_trip;
    }
}

/// The drive's side, for simulators: counts the silence.
class watchdog {
public:
    constexpr watchdog() noexcept = default;
    constexpr watchdog(serial_timeout_action n22, std::uint16_t n23_milliseconds) noexcept
        : action_{n22}, limit_{n23_milliseconds}
    {}

    /// n22 and n23 have been set; the silence goes on.
    constexpr void set_action(serial_timeout_action n22) noexcept { action_ = n22; }
    constexpr void set_fault_time(std::uint16_t n23_milliseconds) noexcept { limit_ = n23_milliseconds; }

    /// A valid message for this drive, also one that it answers with an exception.
    constexpr void heard() noexcept { silence_ = 0; }

    /// So much more time has passed without one. Locks at a time-out, and says what else the drive does.
    constexpr time_out_reaction pass(std::uint32_t microseconds, locks& drive) noexcept
    {
        auto const reaction = reaction_to_time_out(action_, drive.state());
        if (reaction == time_out_reaction::none) {
            silence_ = 0;  // it starts with the message that unlocks
            return reaction;
        }
        auto const limit = std::uint32_t{limit_} * 1000;
        if (microseconds <= limit and silence_ <= limit - microseconds) {  // "longer than": not yet
            silence_ += microseconds;
            return time_out_reaction::none;
        }
        silence_ = 0;
        drive.lock();
        return reaction;
    }

private:
    serial_timeout_action action_  = serial_timeout_action::not_active;
    std::uint16_t         limit_   = 50;
    std::uint32_t         silence_ = 0;  // microseconds
};

/// The master's side: how often to begin an exchange, in microseconds, to talk "at less than 1/2 the interval" of n23.
/// `exchange` is how long one takes: `status_poll_time`, and the time in which the drive thinks. Errors, at 0:
/// `out_of_range` if that is too long for it, as it is for the 50 ms of the factory; else those of `advised_interval`.
[[nodiscard]] constexpr result<std::uint32_t> keep_alive_interval(quantity<unit::second> n23,
                                                                  std::uint32_t          exchange) noexcept
{
    auto const half = advised_interval(n23);
    if (not half) { return half.error(); }
    if (exchange >= *half) { return error{errc::out_of_range, 0}; }
    return *half - 1;
}

}  // namespace drivecodec::smd
