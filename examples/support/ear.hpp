// SPDX-License-Identifier: MIT
#pragma once

#include "decoder.hpp"

#include <cstdint>
#include <optional>

// Who listens to a line, and when something was heard.

namespace support {

/// Microseconds of any clock that does not run backwards.
using timestamp = std::uint64_t;

class ear {
public:
    ear()                      = default;
    ear(ear const&)            = delete;
    ear& operator=(ear const&) = delete;
    virtual ~ear()             = default;

    /// Bytes came, now.
    virtual void hear(drivecodec::bytes received, std::optional<timestamp> now) = 0;

    /// None came for as long as ends a frame.
    virtual void hear_nothing(std::optional<timestamp> now) = 0;

    /// Is there somebody who may answer?
    [[nodiscard]] virtual bool is_waiting_for_response() const = 0;
};

/// Tells a decoder that a request was not answered when its time, in microseconds, is over. Without times it never is.
class timed_ear final : public ear {
public:
    timed_ear(decoder& to, std::uint64_t time_out) : to_{to}, time_out_{time_out} {}

    void hear(drivecodec::bytes received, std::optional<timestamp> now) override
    {
        wait_until(now);
        to_.push(received);
        heard_ = now;
    }

    void hear_nothing(std::optional<timestamp> now) override
    {
        wait_until(now);
        to_.silence();
        if (not heard_) { heard_ = now; }
    }

    [[nodiscard]] bool is_waiting_for_response() const override { return to_.is_waiting_for_response(); }

private:
    void wait_until(std::optional<timestamp> now)
    {
        auto const is_over = now and heard_ and *now > *heard_ and *now - *heard_ > time_out_;
        if (is_over and to_.is_waiting_for_response()) { to_.request_timed_out(); }
    }

    decoder&                 to_;
    std::uint64_t            time_out_;
    std::optional<timestamp> heard_;
};

}  // namespace support
