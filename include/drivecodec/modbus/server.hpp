// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/answer.hpp>
#include <drivecodec/modbus/functions.hpp>

// The server's side of a PDU: a request in, the handler's answer out.

namespace drivecodec::modbus {

namespace detail {

/// What a handler's functions are: those it lists as `functions`, else the public ones.
template <typename Functions, typename Handler>
struct served {
    using type = Functions;
};
template <typename Handler>
struct served<void, Handler> {
    using type = public_functions;
};
template <typename Handler>
    requires requires { typename Handler::functions; }
struct served<void, Handler> {
    using type = typename Handler::functions;
};

/// What became of a request, in one register: the size of the reply that was written, 0 for silence, the negative of an
/// exception, or `echo` and how many bytes of the request to repeat.
using outcome = int;

inline constexpr outcome echo = 0x100;

/// 0, which is no exception, is 04.
[[nodiscard]] constexpr outcome refuse(exception_code code) noexcept
{
    return -static_cast<outcome>(code == exception_code{} ? exception_code::server_device_failure : code);
}

/// Of an answer that is no response: the handler gave too much.
[[nodiscard]] constexpr outcome refuse(error) noexcept
{
    return refuse(exception_code::server_device_failure);
}

/// Writes the response if it fits; else it is exception 04.
template <typename Response>
[[nodiscard]] constexpr outcome write_response(Response const& response, mutable_bytes out) noexcept
{
    auto const size = response.wire_size();
    if (size > out.size() or size > max_pdu_size) { return refuse(exception_code::server_device_failure); }
    response.write(out.first(size));
    return static_cast<outcome>(size);
}

/// Writes the first `size` bytes of the request if they fit; else it is exception 04.
[[nodiscard]] constexpr outcome repeat(bytes pdu, outcome size, mutable_bytes out) noexcept
{
    auto const repeated = pdu.first(static_cast<std::size_t>(size));
    if (repeated.size() > out.size()) { return refuse(exception_code::server_device_failure); }
    copy_bytes(repeated, out);
    return size;
}

/// Writes the reply that `given` stands for; one that does not answer `asked`, or does not fit, becomes exception 04.
template <typename Request, typename Given>
[[nodiscard]] constexpr outcome write_reply(Request const& asked, Given const& given, mutable_bytes out) noexcept
{
    using response = typename Request::function::response;
    if constexpr (std::is_same_v<Given, exception_code>) {
        return refuse(given);
    } else if constexpr (requires { given.has_value(); }) {
        return given ? write_reply(asked, *given, out) : refuse(given.error());
    } else if constexpr (std::is_same_v<Given, done>) {
        if constexpr (requires { asked.echo_size(); }) {
            return echo + static_cast<outcome>(asked.echo_size());
        } else {
            return write_response(asked.reply(), out);
        }
    } else if constexpr (requires { asked.asks_for(given.values.values()); }) {
        return write_reply(asked, given.values.values(), out);
    } else if constexpr (requires { asked.asks_for(given); }) {
        if (not asked.asks_for(given)) { return refuse(exception_code::server_device_failure); }
        decltype(auto) values = asked.exactly(given);
        return write_response(values_payload{Request::function::code, values}, out);
    } else if constexpr (message<Given>) {
        return asked.matches(given).ok() ? write_response(given, out) : refuse(exception_code::server_device_failure);
    } else if constexpr (requires { typename response::values_type; }) {
        return write_reply(asked, typename response::values_type{given}, out);
    } else {
        return write_reply(asked, response::make(given), out);
    }
}

/// Hands a request to the handler and writes what it answers. Precondition: F::request::check(pdu).ok().
template <typename F, typename Handler>
[[nodiscard]] constexpr outcome serve_function(bytes pdu, mutable_bytes out, Handler& handler) noexcept
{
    if (not is_write<F>() and out.empty()) { return 0; }
    auto const asked = F::request::read(pdu);
    auto const given = handler(asked);
    return expects_reply(asked) ? write_reply(asked, given, out) : 0;
}

}  // namespace detail

/// Answers the request in `pdu`: calls the handler, writes the response or the exception to the front of `out`, and
/// returns its size; 0 if there is nothing to send.
///
/// The handler's overload set is the feature list; what it lacks is exception 01 and compiles to nothing. For a request
/// of function F an overload takes `F::request const&` and gives one of these, or an `answer<...>` of it, or an
/// `exception_code`:
///
/// - `F::response`, or what its `make` takes: a `register_view` (from host words or wire bytes) for 03, 04, 23, 24, a
///   `coil_view` for 01, 02, the byte of 07, the bytes of 17, a `record_list<file_values>` for 20;
/// - `done{}` for what writes: 05, 06, 15, 16, 21, 22.
///
/// Every sub-function of 08 comes to the one overload; what that does not serve it answers with exception 01.
///
/// Requests that break the protocol's rules never reach it: exception 02 for a range past the last address, 03 for a
/// wrong quantity, byte count, value or length. An answer that does not fit in `out` or in a PDU, or that is not as
/// long as asked for, is exception 04. Nothing is sent to what has the exception bit set and to Diagnostics' Force
/// Listen Only Mode. An empty `out` means that there is nobody to answer, as to a broadcast: then only writes reach the
/// handler. After Force Listen Only Mode the caller keeps that state, and sends nothing until Restart Communications.
///
/// `Functions` are, unless named, the handler's `functions` if it has such a type, else the public ones. `pdu` and
/// `out` must not overlap.
template <typename Functions = void, typename Handler>
[[nodiscard]] constexpr std::size_t serve_pdu(bytes pdu, mutable_bytes out, Handler&& handler) noexcept
{
    using set          = typename detail::served<Functions, std::remove_cvref_t<Handler>>::type;
    using handler_type = std::remove_reference_t<Handler>;

    if (pdu.empty() or exception_response::is_exception(pdu)) { return 0; }
    auto fault = error{errc::unsupported_function, 0};
    auto given = detail::outcome{0};
    set::find(pdu, [&]<typename F>(std::type_identity<F>) {
        if constexpr (std::is_invocable_v<handler_type&, typename F::request const&>) {
            fault = F::request::check(pdu);
            if (fault.ok()) { given = detail::serve_function<F>(pdu, out, handler); }
        }
    });
    if (not fault.ok()) { given = detail::refuse(to_exception(fault)); }
    if (given >= detail::echo) { given = detail::repeat(pdu, given - detail::echo, out); }
    if (given >= 0) { return static_cast<std::size_t>(given); }
    if (out.size() < exception_response::wire_size()) { return 0; }
    auto const refused = static_cast<function_code>(layout::function.load(pdu));
    exception_response{refused, static_cast<exception_code>(-given)}.write(out);
    return exception_response::wire_size();
}

}  // namespace drivecodec::modbus
