// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/functions/write_single_register.hpp>

// What a controller says: to its user, and to the drive.

namespace drivecodec::smd {

/// What a controller says of its drive.
enum class progress : std::uint8_t {
    reached,  ///< The drive is in the goal.
    waiting,  ///< On the way.
    refused,  ///< `why()`.
    faulted,  ///< The status has the number of the fault.
};

enum class refusal : std::uint8_t {
    none,
    locked,             ///< Exception 01, however often it was unlocked.
    unlock_rejected,    ///< Exception 01 to the unlocking itself: not the password.
    no_such_register,   ///< Exception 02.
    out_of_range,       ///< Exception 03: a speed outside C10 to C11.
    wrong_format,       ///< Exception 04.
    busy,               ///< Exception 06, again and again.
    unknown_exception,  ///< Any other.
    no_reply,
    no_serial_control,  ///< C01 is neither 10 nor 11.
    inhibited,          ///< Terminal 28 is open.
    stopped_elsewhere,  ///< It ran, and was stopped by somebody else, without a lock.
    not_followed,       ///< The drive answers, and does not do it.
};

/// What a controller asks of the drive: the sequence in its order, but for stop.
enum class step : std::uint8_t {
    none,
    poll_status,
    unlock,
    set_reference,
    set_speed,
    set_direction,
    start,
    stop,
    lock,
};

/// One request: `drive_status.read()` to poll, else the write.
struct exchange {
    step                                   what = step::none;
    modbus::write_single_register::request write{};  ///< Of 0 to 0 where it is no write.

    [[nodiscard]] constexpr bool is_write() const noexcept { return what > step::poll_status; }
};

}  // namespace drivecodec::smd
