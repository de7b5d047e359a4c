// SPDX-License-Identifier: MIT
#pragma once

#include "support/serial_port.hpp"

#include <drivecodec/modbus.hpp>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <system_error>
#include <utility>

// The client's side of a line: ask, wait, ask again.

namespace support {

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;

class client {
public:
    using microseconds = std::chrono::microseconds;

    struct settings {
        microseconds timeout = std::chrono::milliseconds{500};  ///< For the reply to begin and to be complete.
        unsigned     retries = 2;                               ///< Further tries when there is no reply.
        microseconds silence = std::chrono::milliseconds{20};   ///< Ends a frame: USB adapters deliver bytes in lumps.
        bool         echo    = false;                           ///< The adapter hears what it sends.
    };

    client(serial_port port, rtu::timing line, settings chosen)
        : port_{std::move(port)}, line_{line}, settings_{chosen}
    {}

    /// Is told of each frame that is sent or heard, also of those that answer something else.
    std::function<void(rtu::frame const&)> trace;

    /// Asks the server until it answers: its response, or why there is none. Nothing if all tries timed out.
    ///
    /// Views inside the response are valid until the next call. A reply is taken only if it answers this request. One
    /// that comes late cannot be told from the reply to a repetition; so after a time-out the next request first waits
    /// until no late reply can come any more. Throws std::system_error if the device is gone.
    template <modbus::message Request>
    [[nodiscard]] std::optional<modbus::reply<Request>> ask(rtu::server_address server, Request const& asked)
    {
        using drivecodec::errc;
        auto const frame = rtu::encode(server, asked, request_);
        if (not frame) { return modbus::reply<Request>{modbus::reply_error{frame.error()}}; }
        if (not rtu::expects_reply(server, asked)) {
            if (not send(*frame)) { return std::nullopt; }
            return modbus::reply<Request>{modbus::reply_error{drivecodec::error{errc::no_reply, 0}}};
        }
        return exchange(*frame, [&](drivecodec::bytes heard) -> std::optional<modbus::reply<Request>> {
            auto const answer = rtu::check(server, asked, heard);
            auto const code   = answer ? errc::none : answer.error().code();
            if (code == errc::unexpected_server or code == errc::unexpected_function
                or code == errc::unexpected_reply) {
                return std::nullopt;  // the reply to something else
            }
            return answer;
        });
    }

    /// The same for the bytes of any PDU; the reply is the PDU of the first frame of that server and function.
    [[nodiscard]] std::optional<drivecodec::bytes> ask_raw(rtu::server_address server, drivecodec::bytes pdu)
    {
        auto const frame = std::span{request_}.first(pdu.size() + rtu::layout::adu::around);
        frame.front()    = server.byte();
        drivecodec::copy_bytes(pdu, frame.subspan(rtu::layout::adu::pdu));
        rtu::write_crc(frame);
        return exchange(frame, [&](drivecodec::bytes heard) -> std::optional<drivecodec::bytes> {
            auto const answer   = rtu::pdu_of(heard);
            auto const function = answer.front() & ~modbus::exception_bit;
            if (heard.front() != server.byte() or function != pdu.front()) { return std::nullopt; }
            return answer;
        });
    }

private:
    using clock = std::chrono::steady_clock;

    /// Sends the frame until `judge` takes a frame as its reply.
    template <typename Judge>
    [[nodiscard]] auto exchange(drivecodec::bytes frame, Judge judge) -> decltype(judge(frame))
    {
        await_late_replies();
        for (unsigned attempt = 0; attempt <= settings_.retries; ++attempt) {
            if (not send(frame)) { continue; }
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
    [[nodiscard]] bool send(drivecodec::bytes frame)
    {
        await_silence();
        reader_ = rtu::reader{rtu::expecting::response};
        tell({.raw = frame, .direction = modbus::direction::request, .aligned = true});
        if (not port_.write_all(frame)) { fail(); }
        return not settings_.echo or skip_echo(frame);
    }

    [[nodiscard]] bool skip_echo(drivecodec::bytes sent)
    {
        std::array<std::uint8_t, 2 * rtu::max_adu_size> received;
        std::size_t                                     size     = 0;
        auto const                                      deadline = clock::now() + settings_.timeout;
        for (;;) {
            auto const rest = rtu::skip_echo(sent, std::span{received}.first(size));
            if (rest) { return reader_.push(*rest).empty(); }
            if (rest.error().code() != drivecodec::errc::truncated or clock::now() >= deadline) { return false; }
            size += read(std::span{received}.subspan(size), until(deadline));
        }
    }

    /// The next valid frame, until the deadline; one that has begun may be finished.
    [[nodiscard]] std::optional<drivecodec::bytes> next_frame(clock::time_point deadline)
    {
        auto const latest = deadline + microseconds{line_.frame_time(rtu::max_adu_size)};
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

    /// Between two frames there are at least 3.5 characters of silence. What is heard meanwhile answers nothing.
    void await_silence()
    {
        auto const deadline = clock::now() + settings_.timeout;
        std::array<std::uint8_t, rtu::max_adu_size> ignored;
        while (read(ignored, microseconds{line_.inter_frame()}) > 0 and clock::now() < deadline) {}
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

    void tell(rtu::frame const& frame) const
    {
        if (trace) { trace(frame); }
    }

    serial_port                                 port_;
    rtu::timing                                 line_;
    settings                                    settings_;
    rtu::reader                                 reader_{rtu::expecting::response};
    std::array<std::uint8_t, rtu::max_adu_size> request_{};
    std::array<std::uint8_t, rtu::max_adu_size> reply_{};
    unsigned                                    unanswered_ = 0;  // requests to which a late reply may come
};

}  // namespace support
