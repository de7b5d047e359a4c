// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/exception.hpp>

// The client's side of a PDU: is this the reply to that request?

namespace drivecodec::modbus {

/// Why there is no response to a request: what is wrong with the bytes, or the exception that the server answered with.
struct reply_error {
    errc           code;
    exception_code exception{};  ///< If `code` is `exception_reply`.
    std::uint16_t  offset{};     ///< Else: where, as in `error`.

    constexpr reply_error(error fault) noexcept : code{fault.code()}, offset{fault.offset()} {}
    constexpr reply_error(exception_code refusal) noexcept : code{errc::exception_reply}, exception{refusal} {}

    [[nodiscard]] constexpr reply_error moved_by(std::size_t base) const noexcept
    {
        return code == errc::exception_reply ? *this : reply_error{error{code, offset + base}};
    }

    friend constexpr bool operator==(reply_error, reply_error) noexcept = default;
};

/// The response to a request, or why there is none.
template <message Request>
using reply = result<typename Request::function::response, reply_error>;

/// The response in `pdu`, if it answers `asked`: its function, its quantity, the fields it repeats.
///
/// Errors: `exception_reply` with the server's exception; `unexpected_function`, `unexpected_reply` for what answers
/// another request; `no_reply` if there is nothing to wait for; those of the response's `check`.
template <message Request>
[[nodiscard]] constexpr reply<Request> check_reply(Request const& asked, bytes pdu) noexcept
{
    using response = typename Request::function::response;

    if (not expects_reply(asked)) { return reply_error{error{errc::no_reply, 0}}; }
    if (exception_response::is_exception(pdu)) {
        if (auto const fault = exception_response::check(pdu); not fault.ok()) { return reply_error{fault}; }
        auto const refusal = exception_response::read(pdu);
        if (refusal.refused != Request::function::code) {
            return reply_error{error{errc::unexpected_function, layout::function.begin}};
        }
        return reply_error{refusal.code};
    }
    if (auto const fault = response::check(pdu); not fault.ok()) { return reply_error{fault}; }
    auto const given = response::read(pdu);
    if (auto const fault = asked.matches(given); not fault.ok()) { return reply_error{fault}; }
    return given;
}

}  // namespace drivecodec::modbus
