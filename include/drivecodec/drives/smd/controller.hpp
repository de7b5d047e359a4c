// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/exception.hpp>
#include <drivecodec/drives/smd/exchange.hpp>
#include <drivecodec/drives/smd/registers.hpp>

// The master's side: runs a drive by the sequence of the smd manual, section 4.8.

namespace drivecodec::smd {

/// Takes a drive to a goal and keeps it there: says what to send, is told what came of it, and neither sends nor waits.
/// One request at a time; each ends with `answered`, `refused` or `lost`. What answers nothing that was asked is ignored.
///
/// - The drive starts once for each goal, after unlocking, reference, speed, direction, and a status that allows it. It
///   starts again only if it has not heard the first, or after it locked itself (exception 01), as it does at a time-out.
/// - A drive that slows down although it is no faster than commanded does not run, it stops: it is started.
/// - A drive that ran and stands still is told its speed once more: exception 01 shows that it locked itself. Else
///   somebody stopped it, and it stays stopped.
/// - A goal to run that ended in `refused` or `faulted` only polls; to try again, set a goal. One that follows late, after
///   `no_reply` or `not_followed`, is `reached`.
/// - Goals to stop or to lock never give up: they report, and go on once in each interval.
/// - Stopped is a drive that does not power the motor, which may still coast. To lock, it is stopped first.
/// - An inhibited drive is not started, unless it has locked itself, when that may be what the time-out did.
/// - A speed that is refused on an unlocked drive, as section 5.6 would have it, is unlocked again, and then `locked`.
class controller {
public:
    struct settings {
        std::uint16_t password = 0;        ///< For register 48: 0 for control only, or C94.
        std::uint32_t interval = 500'000;  ///< Between polls, in microseconds; see `keep_alive_interval`.
        /// How many exchanges in a row may bring nothing new. No more than 9 * (patience + 1) end in `waiting`.
        std::uint16_t patience = 10;
    };

    static constexpr std::uint32_t never = 0xFFFFFFFF;

    /// Without a goal, it polls and writes nothing.
    constexpr controller() noexcept = default;
    constexpr explicit controller(settings chosen) noexcept : settings_{chosen} {}

    //=== goals ===//

    /// Errors, at 0, and the goal stays: `inexact`, `out_of_range` for what is no speed of register 40.
    constexpr error run(direction way, quantity<unit::hertz> speed) noexcept
    {
        auto const raw = serial_speed_command.raw(speed);
        if (not raw) { return raw.error(); }
        if (way != direction::forward and way != direction::reverse) { return {errc::bad_value, 0}; }
        if (goal_ != goal::running or given_up_) {
            auto const unlocked = unlocked_ and not given_up_;
            begin(goal::running);
            unlocked_ = unlocked;
        } else if (way == way_ and *raw == speed_) {
            return {};
        } else {
            speed_set_     = speed_set_ and *raw == speed_ and not probing_;
            direction_set_ = direction_set_ and way == way_;
            checked_       = false;
            start_again();
            pending_ = {};  // if it was the start, the next status tells whether it was heard
        }
        way_   = way;
        speed_ = *raw;
        return {};
    }
    /// At once: whatever is outstanding is forgotten.
    constexpr void stop() noexcept { begin(goal::stopped); }
    constexpr void lock() noexcept { begin(goal::locked); }

    //=== requests ===//

    /// So many microseconds have passed.
    constexpr void pass(std::uint32_t microseconds) noexcept
    {
        since_ = microseconds < never - since_ ? since_ + microseconds : never;
    }

    /// In how many microseconds `next` has a request; `never` while one is outstanding, and once locked.
    [[nodiscard]] constexpr std::uint32_t due_in() const noexcept
    {
        if (pending_.what != step::none or plan() == step::none) { return never; }
        return at_once_ or since_ >= settings_.interval ? 0 : settings_.interval - since_;
    }

    /// What to send now; `step::none` if nothing is due.
    constexpr exchange next() noexcept
    {
        if (due_in() != 0) { return {}; }
        since_   = 0;
        pending_ = request(plan());
        return pending_;
    }

    //=== what came of it ===//

    constexpr smd::progress answered(status_block const& heard) noexcept
    {
        if (pending_.what != step::poll_status) { return progress_; }
        pending_          = {};
        status_           = heard;
        auto const is_new = (seen_ & 1U << unsigned(step::poll_status)) == 0;
        mark(step::poll_status);
        switch (goal_) {
        case goal::watched: say_reached(); break;
        case goal::running: look_running(); break;
        default: look_stopped(); break;
        }
        auto const repeats = plan() == step::poll_status or (plan() == step::stop and not is_new);
        at_once_           = progress_ == progress::waiting and not repeats;
        return progress_;
    }

    /// The echo of a write.
    constexpr smd::progress answered(modbus::write_single_register::request echo) noexcept
    {
        if (not pending_.is_write() or echo.address != pending_.write.address or echo.value != pending_.write.value) {
            return progress_;
        }
        auto const what = pending_.what;
        pending_        = {};
        mark(what);
        auto const was_probing = probing_ and what == step::set_speed;
        done(what);
        if (goal_ == goal::locked and what == step::lock) {
            say_reached();
        } else if (was_probing and is_inhibited() and not was_locked_) {
            give_up(progress::refused, refusal::inhibited);
        } else if (was_probing and ran_) {
            give_up(progress::refused, refusal::stopped_elsewhere);
        } else {
            wait(missing());
        }
        at_once_ = progress_ == progress::waiting and not was_probing;
        if (was_probing) { probing_ = false; }
        return progress_;
    }

    constexpr smd::progress refused(exception why) noexcept
    {
        auto const what = pending_.what;
        if (what == step::none) { return progress_; }
        pending_ = {};
        at_once_ = false;
        switch (why) {
        case exception::command_rejected: rejected(what); return progress_;
        case exception::no_such_register: give_up(progress::refused, refusal::no_such_register); return progress_;
        case exception::data_out_of_range: give_up(progress::refused, refusal::out_of_range); return progress_;
        case exception::wrong_data_format: give_up(progress::refused, refusal::wrong_format); return progress_;
        case exception::slave_device_busy: wait(refusal::busy); return progress_;
        }
        give_up(progress::refused, refusal::unknown_exception);
        return progress_;
    }

    /// No reply, or none that can be read.
    constexpr smd::progress lost() noexcept
    {
        if (pending_.what == step::none) { return progress_; }
        checked_ = false;  // it may have started: look first
        pending_ = {};
        wait(refusal::no_reply);
        at_once_ = progress_ == progress::waiting;
        return progress_;
    }

    [[nodiscard]] constexpr smd::progress progress() const noexcept { return progress_; }
    /// `refusal::none` unless `progress::refused`.
    [[nodiscard]] constexpr refusal why() const noexcept { return why_; }
    /// As last heard, with the fault.
    [[nodiscard]] constexpr status_block const& status() const noexcept { return status_; }

private:
    enum class goal : std::uint8_t { watched, stopped, running, locked };

    //=== of the status ===//

    [[nodiscard]] constexpr bool is_powered() const noexcept
    {
        return status_.operational_status >= operational_status::run_at_0_hz
               and status_.operational_status <= operational_status::decel_override;
    }
    /// It runs, and not only down to a stop: slower, although it is no faster than commanded, is a drive that stops.
    [[nodiscard]] constexpr bool is_following() const noexcept
    {
        auto const is_slowing = status_.operational_status == operational_status::decel
                                or status_.operational_status == operational_status::decel_override;
        auto const has_reason = status_.actual_speed > status_.command_speed
                                or status_.actual_direction != status_.commanded_direction;
        return is_powered() and (not is_slowing or has_reason);
    }
    [[nodiscard]] constexpr bool is_halted() const noexcept
    {
        using enum operational_status;
        auto const now = status_.operational_status;
        return now == stop or now == off or now == inhibit or is_faulted();
    }
    [[nodiscard]] constexpr bool is_about_to_run() const noexcept
    {
        return status_.operational_status == operational_status::start_pending
               or status_.operational_status == operational_status::lower_transistors_switching_on;
    }
    [[nodiscard]] constexpr bool is_inhibited() const noexcept
    {
        return status_.operational_status == operational_status::inhibit;
    }
    [[nodiscard]] constexpr bool is_faulted() const noexcept
    {
        return status_.operational_status == operational_status::fault
               or status_.operational_status == operational_status::fault_lockout
               or (status_.fault != fault::no_fault and not is_powered());
    }

    [[nodiscard]] constexpr bool is_set_up() const noexcept
    {
        return unlocked_ and reference_ and speed_set_ and direction_set_;
    }
    /// What it is that keeps the drive from its goal, if that takes too long.
    [[nodiscard]] constexpr refusal missing() const noexcept
    {
        if (was_locked_ and not is_set_up()) { return refusal::locked; }
        return is_inhibited() ? refusal::inhibited : refusal::not_followed;
    }

    constexpr void look_running() noexcept
    {
        auto const is_there = is_set_up() and is_following() and modbus_controls(status_.control_mode)
                              and status_.commanded_direction == way_
                              and status_.speed_reference == speed_reference::serial;
        if (given_up_ and not(is_there and (why_ == refusal::no_reply or why_ == refusal::not_followed))) { return; }
        if (is_there) {
            started_ = ran_ = true;
            was_locked_     = false;
            say_reached();
            return;
        }
        looked_ = true;
        if (is_faulted()) {
            give_up(progress::faulted, refusal::none);
        } else if (not modbus_controls(status_.control_mode)) {
            give_up(progress::refused, refusal::no_serial_control);
        } else if (is_inhibited() and not unlocked_ and not was_locked_) {
            give_up(progress::refused, refusal::inhibited);
        } else {
            if (is_set_up() and (is_following() or is_about_to_run())) { started_ = true; }
            checked_ = is_set_up() and not started_;
            if ((started_ and is_halted()) or (is_inhibited() and not was_locked_)) {
                probing_   = true;
                speed_set_ = false;
            }
            wait(missing());
        }
    }

    constexpr void look_stopped() noexcept
    {
        auto const is_ours = modbus_controls(status_.control_mode);
        if (is_halted() or (goal_ == goal::locked and rejected_ and not is_ours)) {
            halted_ = true;
            if (goal_ == goal::locked) {
                wait(refusal::not_followed);
            } else if (is_faulted()) {
                give_up(progress::faulted, refusal::none);
            } else {
                say_reached();
            }
            return;
        }
        halted_    = false;
        stop_done_ = false;
        if (not rejected_) {
            wait(refusal::not_followed);
        } else if (is_ours) {
            must_unlock_ = true;
            wait(refusal::locked);
        } else {
            give_up(progress::refused, refusal::no_serial_control);
        }
    }

    //=== of the steps ===//

    [[nodiscard]] constexpr step plan() const noexcept
    {
        if (goal_ == goal::watched or given_up_) { return step::poll_status; }
        if (goal_ == goal::running) {
            if (not looked_) { return step::poll_status; }
            if (not unlocked_) { return step::unlock; }
            if (not reference_) { return step::set_reference; }
            if (not speed_set_) { return step::set_speed; }
            if (not direction_set_) { return step::set_direction; }
            return checked_ and not started_ ? step::start : step::poll_status;
        }
        if (goal_ == goal::locked and lock_done_) { return step::none; }
        if (must_unlock_) { return step::unlock; }
        if (goal_ == goal::locked and halted_) { return step::lock; }
        return stop_done_ ? step::poll_status : step::stop;
    }

    [[nodiscard]] constexpr exchange request(step what) const noexcept
    {
        constexpr auto control = [](command given) { return static_cast<std::uint16_t>(given); };
        constexpr auto one     = drive_control.address();
        switch (what) {
        case step::unlock: return {what, {unlock_commands.address(), settings_.password}};
        case step::set_reference: return {what, {one, control(command::serial_speed_reference)}};
        case step::set_speed: return {what, {serial_speed_command.address(), speed_}};
        case step::set_direction:
            return {what, {one, control(way_ == direction::forward ? command::set_forward : command::set_reverse)}};
        case step::start: return {what, {one, control(command::start)}};
        case step::stop: return {what, {one, control(command::stop)}};
        case step::lock: return {what, {one, control(command::lock)}};
        case step::none:
        case step::poll_status: break;
        }
        return {what, {0, 0}};
    }

    constexpr void done(step what) noexcept
    {
        switch (what) {
        case step::unlock:
            unlocked_    = true;
            must_unlock_ = rejected_ = false;
            break;
        case step::set_reference: reference_ = true; break;
        case step::set_speed: speed_set_ = true; break;
        case step::set_direction: direction_set_ = true; break;
        case step::start:
            started_ = true;
            checked_ = false;
            break;
        case step::stop:
            stop_done_ = true;
            rejected_  = false;
            break;
        case step::lock:
            lock_done_ = true;
            unlocked_  = false;
            break;
        case step::none:
        case step::poll_status: break;
        }
    }

    /// Exception 01.
    constexpr void rejected(step what) noexcept
    {
        if (what == step::lock) {  // as locked as can be
            done(what);
            say_reached();
        } else if (what == step::unlock) {
            unlocked_ = must_unlock_ = false;
            give_up(progress::refused, refusal::unlock_rejected);
        } else if (what == step::poll_status) {
            give_up(progress::refused, refusal::locked);
        } else {
            unlocked_ = reference_ = speed_set_ = direction_set_ = false;
            looked_ = checked_ = started_ = ran_ = probing_ = false;
            was_locked_ = rejected_ = stop_done_ = true;
            wait(refusal::locked);
            at_once_ = progress_ == progress::waiting;
        }
    }

    //=== of the goal ===//

    constexpr void begin(goal wanted) noexcept
    {
        auto const unlocked = unlocked_;
        *this               = controller{settings_, status_};
        unlocked_           = unlocked;
        goal_               = wanted;
    }
    constexpr controller(settings chosen, status_block const& last) noexcept : settings_{chosen}, status_{last} {}

    constexpr void start_again() noexcept
    {
        seen_     = 0;
        left_     = std::uint32_t{settings_.patience};
        progress_ = progress::waiting;
        why_      = refusal::none;
        given_up_ = false;
        at_once_  = true;
    }
    constexpr void say_reached() noexcept
    {
        start_again();
        progress_ = progress::reached;
        at_once_  = false;
    }
    constexpr void give_up(smd::progress as, refusal why) noexcept
    {
        progress_ = as;
        why_      = why;
        given_up_ = goal_ == goal::running;
        if (why != refusal::none) { left_ = 0; }
    }
    constexpr void wait(refusal otherwise) noexcept
    {
        if (given_up_) { return; }
        if (left_ == 0) { return give_up(progress::refused, otherwise); }
        --left_;
        progress_ = progress::waiting;
        why_      = refusal::none;
    }
    /// Each step that is done for the first time is a sign of life.
    constexpr void mark(step what) noexcept
    {
        auto const bit = 1U << static_cast<unsigned>(what);
        if ((seen_ & bit) != 0) { return; }
        seen_ = static_cast<std::uint16_t>(seen_ | bit);
        if (progress_ == progress::waiting) { left_ = std::uint32_t{settings_.patience} + 1; }
    }

    settings      settings_{};
    status_block  status_{};
    exchange      pending_{};
    std::uint32_t since_    = 0;
    std::uint32_t left_     = settings_.patience;
    std::uint16_t seen_     = 0;
    std::uint16_t speed_    = 0;
    direction     way_      = direction::forward;
    goal          goal_     = goal::watched;
    smd::progress progress_ = progress::waiting;
    refusal       why_      = refusal::none;
    bool          at_once_  = true;
    bool          given_up_ = false;  // to run; the other goals go on

    bool looked_ = false, unlocked_ = false, reference_ = false, speed_set_ = false, direction_set_ = false;
    bool checked_    = false;  // set up, and the status since then allows to start
    bool started_    = false;
    bool ran_        = false;
    bool probing_    = false;  // by the speed, whether the drive has locked itself
    bool was_locked_ = false;

    bool stop_done_ = false, halted_ = false, rejected_ = false, must_unlock_ = false, lock_done_ = false;
};

}  // namespace drivecodec::smd
