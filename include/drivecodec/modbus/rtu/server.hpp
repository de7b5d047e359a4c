// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/rtu/framing.hpp>
#include <drivecodec/modbus/server.hpp>

// The server's side of the line.

namespace drivecodec::modbus::rtu {

/// Answers the frame `adu` as the server `own`: the frame to send, at the front of `reply`; empty if there is none.
///
/// Silent for frames of other servers, damaged ones and broadcasts, of which only writes reach the handler. For the
/// handler, and for what is answered with which exception, see `serve_pdu`. `adu` must not overlap `reply`; of its
/// bytes 256 are always enough.
template <typename Functions = void, crc16::algorithm Crc = crc16::by_default, typename Handler>
[[nodiscard]] constexpr bytes serve(server_address own, bytes adu, mutable_bytes reply, Handler&& handler) noexcept
{
    if (adu.size() < min_adu_size or adu.size() > max_adu_size) { return {}; }
    auto const address      = layout::adu::address.load(adu);
    auto const is_broadcast = address == server_address{broadcast}.byte();
    if ((address != own.byte() and not is_broadcast) or not has_valid_crc<Crc>(adu)) { return {}; }

    // Of a broadcast there is nobody to answer, of a reply without room nothing to say it with.
    auto const room = is_broadcast or reply.size() < min_adu_size ? 0 : reply.size() - layout::adu::around;
    auto const size = serve_pdu<Functions>(pdu_of(adu), reply.subspan(room == 0 ? 0 : layout::adu::pdu, room), handler);
    if (size == 0) { return {}; }
    reply = reply.first(size + layout::adu::around);
    layout::adu::address.store(reply, own.byte());
    write_crc<Crc>(reply);
    return reply;
}

/// The same for a frame from a `reader`. A server acts on aligned requests only: what was found amid dropped bytes may
/// be part of another frame's payload.
template <typename Functions = void, crc16::algorithm Crc = crc16::by_default, typename Handler>
[[nodiscard]] constexpr bytes serve(server_address own, frame const& received, mutable_bytes reply,
                                    Handler&& handler) noexcept
{
    if (not received.aligned or received.direction != direction::request) { return {}; }
    return serve<Functions, Crc>(own, received.raw, reply, handler);
}

}  // namespace drivecodec::modbus::rtu
