// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/rtu/framing.hpp>
#include <drivecodec/text/modbus/describe.hpp>

namespace drivecodec::modbus::rtu {

/// `server 17`, `broadcast`, `server 250 (reserved)`
constexpr void write_text(text_writer& out, server_address address) noexcept
{
    if (address.is_broadcast()) {
        out.put("broadcast");
    } else {
        out.put("server ").decimal(address.byte()).put(address.is_reserved() ? " (reserved)" : "");
    }
}

/// A frame that a reader found as one readable line, in `out`; ends with "..." if it does not fit.
///
///     server 17  request  03 read_holding_registers  first=107 count=3
///     server 17  response  03 read_holding_registers  exception 02 illegal_data_address
///     server 1  request  03 read_holding_registers  bad_quantity at byte 4: 01 03 00 00 00 7E C5 EA
///
/// Never fails: what does not decode is described with its error, at an offset in the frame, and in hexadecimal. With
/// the PDU of the `request` heard before, a response shows as many coils as that asked for. A run of dropped bytes is
/// described by <drivecodec/text/core.hpp>.
template <typename Functions = public_functions>
[[nodiscard]] constexpr std::string_view describe(frame const& found, std::span<char> out, bytes request = {}) noexcept
{
    text_writer text{out};
    write_text(text, server_address::reserved(found.address()));
    text.put("  ");
    auto const fault = write_message<Functions>(text, found.direction, found.pdu(), request);
    if (not fault.ok()) {
        auto const base = fault.code() == errc::truncated ? layout::adu::around : layout::adu::pdu;
        write_refused(text, fault.moved_by(base), found.raw);
    }
    if (not found.aligned) { text.put("  (found amid dropped bytes)"); }
    return text.view_with_ellipsis();
}

}  // namespace drivecodec::modbus::rtu
