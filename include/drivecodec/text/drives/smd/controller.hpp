// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/controller.hpp>
#include <drivecodec/drives/smd/watchdog.hpp>

#include <string_view>

// An enumerator's own name; empty for a value without one.

namespace drivecodec::smd {

[[nodiscard]] constexpr std::string_view to_string(progress now) noexcept
{
    switch (now) {
    case progress::reached: return "reached";
    case progress::waiting: return "waiting";
    case progress::refused: return "refused";
    case progress::faulted: return "faulted";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(refusal why) noexcept
{
    switch (why) {
    case refusal::none: return "none";
    case refusal::locked: return "locked";
    case refusal::unlock_rejected: return "unlock_rejected";
    case refusal::no_such_register: return "no_such_register";
    case refusal::out_of_range: return "out_of_range";
    case refusal::wrong_format: return "wrong_format";
    case refusal::busy: return "busy";
    case refusal::unknown_exception: return "unknown_exception";
    case refusal::no_reply: return "no_reply";
    case refusal::no_serial_control: return "no_serial_control";
    case refusal::inhibited: return "inhibited";
    case refusal::stopped_elsewhere: return "stopped_elsewhere";
    case refusal::not_followed: return "not_followed";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(step what) noexcept
{
    switch (what) {
    case step::none: return "none";
    case step::poll_status: return "poll_status";
    case step::unlock: return "unlock";
    case step::set_reference: return "set_reference";
    case step::set_speed: return "set_speed";
    case step::set_direction: return "set_direction";
    case step::start: return "start";
    case step::stop: return "stop";
    case step::lock: return "lock";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(exception code) noexcept
{
    switch (code) {
    case exception::command_rejected: return "command_rejected";
    case exception::no_such_register: return "no_such_register";
    case exception::data_out_of_range: return "data_out_of_range";
    case exception::wrong_data_format: return "wrong_data_format";
    case exception::slave_device_busy: return "slave_device_busy";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(lock_state state) noexcept
{
    switch (state) {
    case lock_state::locked: return "locked";
    case lock_state::control: return "control";
    case lock_state::parameters: return "parameters";
    case lock_state::both: return "both";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(time_out_reaction reaction) noexcept
{
    switch (reaction) {
    case time_out_reaction::none: return "none";
    case time_out_reaction::lock: return "lock";
    case time_out_reaction::lock_and_inhibit: return "lock_and_inhibit";
    case time_out_reaction::lock_and_stop: return "lock_and_stop";
    case time_out_reaction::lock_and_trip: return "lock_and_trip";
    }
    return {};
}

/// The same as a sentence, with what to do about it; empty for `none`.
[[nodiscard]] constexpr std::string_view explain(refusal why) noexcept
{
    switch (why) {
    case refusal::none: return {};
    case refusal::locked: return "the drive is locked, and was so again after each unlocking";
    case refusal::unlock_rejected: return "the drive does not unlock: the password is not that of C94";
    case refusal::no_such_register: return "the drive does not have this register";
    case refusal::out_of_range: return "out of range: the speed must be between C10 and C11";
    case refusal::wrong_format: return "the drive calls it a wrong data format, or several bits in register 1";
    case refusal::busy: return "the drive stays busy";
    case refusal::unknown_exception: return "the drive answers an exception that its manual does not have";
    case refusal::no_reply: return "the drive does not answer";
    case refusal::no_serial_control: return "no control over Modbus: set C01 to 10 or 11";
    case refusal::inhibited: return "the drive is inhibited: close terminal 28";
    case refusal::stopped_elsewhere: return "the drive was stopped, but not from here";
    case refusal::not_followed: return "the drive answers, but does not follow";
    }
    return {};
}

}  // namespace drivecodec::smd
