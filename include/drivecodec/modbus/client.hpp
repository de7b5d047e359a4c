// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/exception.hpp>

// The client's side of a PDU: is this the reply to that request?

namespace drivecodec::modbus {

/// Why there is no response to a request: what is wrong with the bytes and where, as in `error`; or, if `code()` is
/// `exception_reply`, the exception that the server answered with.
class reply_error : public error {
public:
    constexpr reply_error(error fault) noexcept : error{fault} {}
    constexpr reply_error(exception_code refusal) noexcept
        : error{errc::exception_reply, static_cast<std::size_t>(refusal)}
    {}

    /// Precondition: code() == errc::exception_reply.
    [[nodiscard]] constexpr exception_code exception() const noexcept { return static_cast<exception_code>(offset()); }
};

/// The response to a request, or why there is none.
template <message Request>
using reply = result<typename Request::function::response, reply_error>;

namespace detail {

/// What is wrong with `pdu` for a client of `code`, where `fault` is what is wrong with it as a response of that
/// function: of an exception that is its code, or what is wrong with the exception.
[[nodiscard]] constexpr error or_exception(error fault, bytes pdu, function_code code) noexcept
{
    if (not exception_response::is_exception(pdu)) { return fault; }
    if (layout::function.load(pdu) != (to_byte(code) | exception_bit)) {
        return {errc::unexpected_function, layout::function.begin};
    }
    auto const malformed = exception_response::check(pdu);
    return malformed.ok() ? reply_error{exception_response::read(pdu).code} : malformed;
}

/// Precondition: `pdu` is a response of the function. Offsets count from `base` bytes before the PDU.
template <message Request>
[[nodiscard]] constexpr reply<Request> match_reply(Request const& asked, bytes pdu, std::size_t base) noexcept
{
    auto given =
        Request::function::response::read(pdu);  // not const: g++ 12 keeps const objects in memory, 28 bytes of code
    if (auto const fault = asked.matches(given); not fault.ok()) { return reply_error{fault.moved_by(base)}; }
    return given;
}

}  // namespace detail

/// The response in `pdu`, if it answers `asked`: its function, its quantity, the fields it repeats.
///
/// Errors: `exception_reply` with the server's exception; `unexpected_function`, `unexpected_reply` for what answers
/// another request; `no_reply` if there is nothing to wait for; those of the response's `check`.
template <message Request>
[[nodiscard]] constexpr reply<Request> check_reply(Request const& asked, bytes pdu) noexcept
{
    if (not expects_reply(asked)) { return reply_error{error{errc::no_reply, 0}}; }
    if (pdu.empty()) { return reply_error{error{errc::truncated, exception_response::wire_size()}}; }
    using function   = typename Request::function;
    auto const fault = detail::or_exception(function::response::check(pdu), pdu, function::code);
    if (not fault.ok()) { return reply_error{fault}; }
    return detail::match_reply(asked, pdu, 0);
}

/// Refused: a response that borrows its bytes would outlive them. Name the buffer first.
template <message Request, owning_temporary Temporary>
    requires(not fixed_size<typename Request::function::response>)
reply<Request> check_reply(Request const&, Temporary&&) = delete;

}  // namespace drivecodec::modbus
