// SPDX-License-Identifier: MIT
#pragma once

#include "support/line_client.hpp"
#include "support/rtu_line.hpp"

#include <array>
#include <cstdint>
#include <optional>

// The Modbus client's side of a line: ask, wait, ask again.

namespace support {

class client : public line_client<rtu_line> {
public:
    using line_client::line_client;

    /// Asks the server until it answers: its response, or why there is none. Nothing if all tries timed out.
    ///
    /// Views inside the response are valid until the next call. A reply is taken only if it answers this request. One
    /// that comes late cannot be told from the reply to a repetition; so after a time-out the next request first waits
    /// until no late reply can come any more. Throws std::system_error if the device is gone.
    template <modbus::message Request>
    [[nodiscard]] std::optional<modbus::reply<Request>> ask(rtu::server_address server, Request const& asked)
    {
        using drivecodec::errc;
        auto const adu = rtu::encode(server, asked, request_);
        if (not adu) { return modbus::reply<Request>{modbus::reply_error{adu.error()}}; }
        if (not rtu::expects_reply(server, asked)) {
            if (not send(*adu)) { return std::nullopt; }
            return modbus::reply<Request>{modbus::reply_error{drivecodec::error{errc::no_reply, 0}}};
        }
        return exchange(*adu, [&](drivecodec::bytes heard) -> std::optional<modbus::reply<Request>> {
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
        auto const adu = std::span{request_}.first(pdu.size() + rtu::layout::adu::around);
        adu.front()    = server.byte();
        drivecodec::copy_bytes(pdu, adu.subspan(rtu::layout::adu::pdu));
        rtu::write_crc(adu);
        return exchange(adu, [&](drivecodec::bytes heard) -> std::optional<drivecodec::bytes> {
            auto const answer   = rtu::pdu_of(heard);
            auto const function = answer.front() & ~modbus::exception_bit;
            if (heard.front() != server.byte() or function != pdu.front()) { return std::nullopt; }
            return answer;
        });
    }

private:
    std::array<std::uint8_t, rtu::max_adu_size> request_{};
};

}  // namespace support
