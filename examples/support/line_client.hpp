// SPDX-License-Identifier: MIT
#pragma once

#include "support/serial_port.hpp"

#include <drivecodec/modbus/rtu/client.hpp>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <system_error>
#include <utility>

// The asking side of a line, whatever is spoken on it: send, wait, send again.

namespace support {

/// `Line` is what is spoken, as rtu_line or fc_line.
template <typename Line>
class line_client {
public:
    using frame        = typename Line::frame;
    using microseconds = std::chrono::microseconds;

    struct settings {
        microseconds timeout = std::chrono::milliseconds{500};  ///< For the reply to begin and to be complete.
        unsigned     retries = 2;                               ///< Further tries when there is no reply.
        microseconds silence = std::chrono::milliseconds{20};   ///< Ends a frame: USB adapters deliver bytes in lumps.
        bool         echo    = false;                           ///< The adapter hears what it sends.
    };

    line_client(serial_port port, Line line, settings chosen) : port_{std::move(port)}, line_{line}, settings_{chosen}
    {}

    /// Is told of each frame that is sent or heard, also of those that answer something else.
    std::function<void(frame const&)> trace;

protected:
    /// Sends the frame until `judge` takes a frame as its reply.
    template <typename Judge>
    [[nodiscard]] auto exchange(drivecodec::bytes raw, Judge judge) -> decltype(judge(raw))
    {
        await_late_replies();
        for (unsigned attempt = 0; attempt <= settings_.retries; ++attempt) {
            if (not send(raw)) { continue; }
            ++unanswered_;
            auto const deadline = clock::now() + settings_.timeout;
            while (auto const heard = next_frame(deadline)) {
                if (auto const answer = judge(*heard); answer) {
                    --unanswered_;
                    return answer;
                }
            }
        }
        return std::nullopt;
    }

    /// False if what the adapter echoes is not what was sent: a collision, or no echo at all.
    [[nodiscard]] bool send(drivecodec::bytes raw)
    {
        await_silence();
        reader_ = Line::reader_of_responses();
        tell(Line::request(raw));
        if (not port_.write_all(raw)) { fail(); }
        return not settings_.echo or skip_echo(raw);
    }

private:
    using clock = std::chrono::steady_clock;

    [[nodiscard]] bool skip_echo(drivecodec::bytes sent)
    {
        std::array<std::uint8_t, 2 * Line::max_size> received;
        std::size_t                                  size     = 0;
        auto const                                   deadline = clock::now() + settings_.timeout;
        for (;;) {
            auto const rest = drivecodec::modbus::rtu::skip_echo(sent, std::span{received}.first(size));
            if (rest) { return reader_.push(*rest).empty(); }
            if (rest.error().code() != drivecodec::errc::truncated or clock::now() >= deadline) { return false; }
            size += read(std::span{received}.subspan(size), until(deadline));
        }
    }

    /// The next valid frame, until the deadline; one that has begun may be finished.
    [[nodiscard]] std::optional<drivecodec::bytes> next_frame(clock::time_point deadline)
    {
        auto const latest = deadline + microseconds{line_.time_of_longest()};
        for (auto in_frame = false;;) {
            while (auto const item = reader_.next()) {
                auto const* found = item.frame();
                if (found == nullptr) { continue; }
                tell(*found);
                auto const copy = std::span{reply_}.first(found->raw.size());
                drivecodec::copy_bytes(found->raw, copy);
                return copy;
            }
            auto const now = clock::now();
            if (now >= (in_frame ? latest : deadline)) { return std::nullopt; }
            auto const count = read(reader_.prepare(), in_frame ? settings_.silence : until(deadline));
            reader_.commit(count);
            if (count == 0) { reader_.silence(); }
            in_frame = count > 0;
        }
    }

    /// Between two frames there has to be a silence. What is heard meanwhile answers nothing.
    void await_silence()
    {
        auto const                               deadline = clock::now() + settings_.timeout;
        std::array<std::uint8_t, Line::max_size> ignored;
        while (read(ignored, microseconds{line_.silence()}) > 0 and clock::now() < deadline) {}
    }

    void await_late_replies()
    {
        auto const deadline = clock::now() + settings_.timeout;
        while (unanswered_ > 0 and next_frame(deadline)) { --unanswered_; }
        unanswered_ = 0;
    }

    [[nodiscard]] static microseconds until(clock::time_point deadline)
    {
        auto const left = std::chrono::duration_cast<microseconds>(deadline - clock::now());
        return left > microseconds{0} ? left : microseconds{0};
    }

    std::size_t read(drivecodec::mutable_bytes into, microseconds timeout)
    {
        auto const count = port_.read(into, static_cast<std::uint32_t>(timeout.count()));
        if (not count) { fail(); }
        return *count;
    }

    [[noreturn]] void fail() const { throw std::system_error{errno, std::generic_category(), port_.name()}; }

    void tell(frame const& told) const
    {
        if (trace) { trace(told); }
    }

    serial_port                              port_;
    Line                                     line_;
    settings                                 settings_;
    typename Line::reader                    reader_ = Line::reader_of_responses();
    std::array<std::uint8_t, Line::max_size> reply_{};
    unsigned                                 unanswered_ = 0;  // requests to which a late reply may come
};

}  // namespace support
