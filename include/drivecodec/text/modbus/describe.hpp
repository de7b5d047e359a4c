// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/functions.hpp>
#include <drivecodec/text/core.hpp>
#include <drivecodec/text/modbus/field_writer.hpp>
#include <drivecodec/text/modbus/function_code.hpp>
#include <drivecodec/text/modbus/visit_message.hpp>

namespace drivecodec::modbus {

/// What `describe` writes of a public function is never longer. The longest are event logs.
inline constexpr std::size_t max_description_size = 10'240;

/// The name of the function in `pdu`: the set's, or else the specification's. Empty if neither knows it.
template <typename Functions = public_functions>
[[nodiscard]] constexpr std::string_view function_name(bytes pdu) noexcept
{
    if (auto const* name = Functions::name(pdu); name != nullptr) { return name; }
    if (pdu.empty()) { return {}; }
    return to_string(static_cast<function_code>(layout::function.load(pdu) & ~exception_bit));
}

/// `request  03 read_holding_registers  first=107 count=3`. Returns why not, where the message does not decode: then
/// there are no fields.
template <typename Functions = public_functions>
constexpr error write_message(text_writer& out, direction which, bytes pdu, bytes request = {}) noexcept
{
    out.put(to_string(which));
    if (not pdu.empty()) {
        auto const code = static_cast<std::uint8_t>(layout::function.load(pdu) & ~exception_bit);
        out.put(code < 10 ? "  0" : "  ").decimal(code);
    }
    if (auto const name = function_name<Functions>(pdu); not name.empty()) { out.put(' ').put(name); }

    return visit_message<Functions>(which, pdu, request, [&]<typename Message>(Message const& message) {
        if constexpr (std::is_same_v<Message, exception_response>) {
            auto const code = static_cast<std::uint8_t>(message.code);
            out.put(code < 10 ? "  exception 0" : "  exception ").decimal(code);
            if (auto const name = to_string(message.code); not name.empty()) { out.put(' ').put(name); }
        } else {
            write_fields(out, message, "  ");
        }
    });
}

/// `  bad_quantity at byte 3: 03 00 00 00 7E`
constexpr void write_refused(text_writer& out, error fault, bytes raw) noexcept
{
    out.put("  ");
    write_text(out, fault);
    out.put(raw.empty() ? "" : ": ").hex(raw);
}

/// A PDU as one readable line, in `out`; ends with "..." if it does not fit.
///
///     request  03 read_holding_registers  first=107 count=3
///     response  03 read_holding_registers  byte_count=6 registers=[555 0 100]
///     response  03 read_holding_registers  exception 02 illegal_data_address
///     request  03 read_holding_registers  bad_quantity at byte 3: 03 00 00 00 7E
///
/// Never fails: what does not decode is described with its error, at an offset in `pdu`, and in hexadecimal. With the
/// `request` heard before, a response shows as many coils as that asked for.
template <typename Functions = public_functions>
[[nodiscard]] constexpr std::string_view describe(direction which, bytes pdu, std::span<char> out,
                                                  bytes request = {}) noexcept
{
    text_writer text{out};
    auto const  fault = write_message<Functions>(text, which, pdu, request);
    if (not fault.ok()) { write_refused(text, fault, pdu); }
    return text.view_with_ellipsis();
}

}  // namespace drivecodec::modbus
