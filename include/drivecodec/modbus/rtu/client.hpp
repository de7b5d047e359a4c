// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/client.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

// The client's side of the line.

namespace drivecodec::modbus::rtu {

/// Will a server answer this? None answers a broadcast.
template <message Request>
[[nodiscard]] constexpr bool expects_reply(server_address address, Request const& asked) noexcept
{
    return not address.is_broadcast() and modbus::expects_reply(asked);
}

namespace detail {

/// One function for all requests, for the sake of firmware.
template <crc16::algorithm Crc>
[[nodiscard]] constexpr error check_reply_adu(bytes adu, std::uint8_t address, function_code code, error fault) noexcept
{
    constexpr auto shortest =
        layout::adu::around + exception_response::wire_size();  // no reply is shorter than an exception
    if (adu.size() < shortest) { return {errc::truncated, shortest}; }
    return check_adu<Crc>(adu, address, modbus::detail::or_exception(fault, pdu_of(adu), code));
}

}  // namespace detail

/// The response in the frame `adu`, if it is the reply of the server `address` to `asked`; a stale or foreign reply is
/// not.
///
/// Errors, with offsets in `adu`: `no_reply` to a broadcast; `truncated`, `bad_checksum`, `unexpected_server`; those of
/// `check_reply`. Views inside the response point into `adu`.
template <crc16::algorithm Crc = crc16::by_default, message Request>
[[nodiscard]] constexpr reply<Request> check(server_address address, Request const& asked, bytes adu) noexcept
{
    if (not expects_reply(address, asked)) { return reply_error{error{errc::no_reply, 0}}; }
    using function   = typename Request::function;
    auto const inner = function::response::check(pdu_or_nothing(adu));
    auto const fault = detail::check_reply_adu<Crc>(adu, address.byte(), function::code, inner);
    if (not fault.ok()) { return reply_error{fault}; }
    return modbus::detail::match_reply(asked, pdu_of(adu), layout::adu::pdu);
}

/// Refused: a response that borrows its bytes would outlive them. Name the buffer first.
template <crc16::algorithm Crc = crc16::by_default, message Request, owning_temporary Temporary>
    requires(not fixed_size<typename Request::function::response>)
reply<Request> check(server_address, Request const&, Temporary&&) = delete;

/// What follows one's own request, for adapters on which one hears oneself.
///
/// Errors: `truncated` while the echo is not complete; `unexpected_reply` at the first byte that is not the echo's: a
/// collision, or an adapter without an echo.
[[nodiscard]] constexpr result<bytes> skip_echo(bytes sent, bytes received) noexcept
{
    for (std::size_t i = 0; i < sent.size() and i < received.size(); ++i) {
        if (sent[i] != received[i]) { return error{errc::unexpected_reply, i}; }
    }
    if (received.size() < sent.size()) { return error{errc::truncated, sent.size()}; }
    return received.subspan(sent.size());
}

}  // namespace drivecodec::modbus::rtu
