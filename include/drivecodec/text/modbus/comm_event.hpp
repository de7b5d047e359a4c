// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/index_iterator.hpp>
#include <drivecodec/modbus/comm_event.hpp>
#include <drivecodec/text/writer.hpp>

namespace drivecodec::modbus {

[[nodiscard]] constexpr std::string_view to_string(comm_event_kind kind) noexcept
{
    switch (kind) {
    case comm_event_kind::communication_restart: return "communication_restart";
    case comm_event_kind::entered_listen_only_mode: return "entered_listen_only_mode";
    case comm_event_kind::receive: return "receive";
    case comm_event_kind::send: return "send";
    case comm_event_kind::unknown: return "unknown";
    }
    return {};
}

/// The kind, then the flags that are set: `receive+broadcast_received`. Bits without a meaning are not shown, except in
/// a byte of which nothing is known: `0x10`.
constexpr void write_text(text_writer& out, comm_event event) noexcept
{
    auto const kind = event.kind();
    if (kind == comm_event_kind::unknown) {
        out.put("0x").hex(event.raw);
        return;
    }
    auto const show = [&](flag<comm_event> bit, std::string_view name) {
        if (event.test(bit)) { out.put('+').put(name); }
    };
    out.put(to_string(kind));
    if (kind == comm_event_kind::receive) {
        show(comm_event::communication_error, "communication_error");
        show(comm_event::character_overrun, "character_overrun");
        show(comm_event::in_listen_only_mode, "in_listen_only_mode");
        show(comm_event::broadcast_received, "broadcast_received");
    } else if (kind == comm_event_kind::send) {
        show(comm_event::read_exception_sent, "read_exception_sent");
        show(comm_event::server_abort_exception_sent, "server_abort_exception_sent");
        show(comm_event::server_busy_exception_sent, "server_busy_exception_sent");
        show(comm_event::program_nak_exception_sent, "program_nak_exception_sent");
        show(comm_event::write_timeout, "write_timeout");
        show(comm_event::in_listen_only_mode, "in_listen_only_mode");
    }
}

/// The bytes of an event log as what they are.
struct comm_event_list {
    bytes log;

    [[nodiscard]] constexpr std::size_t size() const noexcept { return log.size(); }
    [[nodiscard]] constexpr comm_event  operator[](std::size_t index) const noexcept
    {
        return comm_event::from_raw(log.data()[index]);
    }
    [[nodiscard]] constexpr index_iterator<comm_event_list, comm_event> begin() const noexcept { return {*this, 0}; }
    [[nodiscard]] constexpr index_iterator<comm_event_list, comm_event> end() const noexcept { return {*this, size()}; }
};

}  // namespace drivecodec::modbus
