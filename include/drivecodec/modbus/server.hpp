// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/functions.hpp>

// The server's side of a PDU: a request in, the handler's answer out.

namespace drivecodec::modbus {

/// What a handler answers: a `T`, or why not.
template <typename T>
using answer = result<T, exception_code>;

/// A handler's answer to a request that writes: it is done. The response repeats the request's fields.
struct done {};

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

/// What became of a request: a reply of `size` bytes, an exception, or, if both are none, silence.
struct outcome {
    std::uint8_t   size = 0;
    exception_code exception{};

    constexpr outcome() noexcept = default;
    constexpr explicit outcome(std::size_t written) noexcept : size{static_cast<std::uint8_t>(written)} {}
    constexpr explicit outcome(exception_code refusal) noexcept : exception{refusal} {}
};

template <typename T>
inline constexpr bool is_answer = false;
template <typename T>
inline constexpr bool is_answer<result<T, exception_code>> = true;

/// Writes the response if it fits; else it is exception 04.
template <typename Response>
[[nodiscard]] constexpr outcome write_response(Response const& response, mutable_bytes out) noexcept
{
    auto const size = response.wire_size();
    if (size > out.size()) { return outcome{exception_code::server_device_failure}; }
    response.write(out.first(size));
    return outcome{size};
}

/// Writes the reply that `given` stands for; one that does not answer `asked`, or does not fit, becomes exception 04.
template <typename Request, typename Given>
[[nodiscard]] constexpr outcome write_reply(Request const& asked, Given const& given, mutable_bytes out) noexcept
{
    if constexpr (std::is_same_v<Given, exception_code>) {
        return outcome{given};
    } else if constexpr (is_answer<Given>) {
        return given ? write_reply(asked, *given, out) : outcome{given.error()};
    } else if constexpr (std::is_same_v<Given, done>) {
        return write_response(asked.reply(), out);
    } else if constexpr (message<Given>) {
        return asked.matches(given).ok() ? write_response(given, out) : outcome{exception_code::server_device_failure};
    } else {
        auto const made = Request::function::response::make(given);
        if constexpr (requires { made.has_value(); }) {
            return made ? write_reply(asked, *made, out) : outcome{exception_code::server_device_failure};
        } else {
            return write_reply(asked, made, out);
        }
    }
}

/// Hands a request to the handler and writes what it answers. Precondition: F::request::check(pdu).ok().
template <typename F, typename Handler>
[[nodiscard]] constexpr outcome serve_function(bytes pdu, mutable_bytes out, Handler& handler, bool is_broadcast) noexcept
{
    using request = typename F::request;
    if (is_broadcast and not is_write<F>()) { return {}; }
    auto const asked = request::read(pdu);
    auto const given = handler(asked);
    return is_broadcast or not expects_reply(asked) ? outcome{} : write_reply(asked, given, out);
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
/// Requests that break the protocol's rules never reach it: exception 02 for a range past the last address, 03 for a wrong
/// quantity, byte count, value or length. An answer that does not fit in `out` or in a PDU, or that is not as long as asked
/// for, is exception 04. Nothing is sent to what has the exception bit set, to a broadcast, of which only writes
/// reach the handler, and to Diagnostics' Force Listen Only Mode.
///
/// `Functions` are, unless named, the handler's `functions` if it has such a type, else the public ones. `pdu` and
/// `out` must not overlap.
template <typename Functions = void, typename Handler>
[[nodiscard]] constexpr std::size_t serve_pdu(bytes pdu, mutable_bytes out, Handler&& handler,
                                              bool is_broadcast = false) noexcept
{
    using set     = typename detail::served<Functions, std::remove_cvref_t<Handler>>::type;
    using handler_type = std::remove_reference_t<Handler>;

    if (pdu.empty() or exception_response::is_exception(pdu)) { return 0; }
    out = out.first(out.size() < max_pdu_size ? out.size() : max_pdu_size);

    auto fault = error{errc::unsupported_function, 0};
    auto given = detail::outcome{};
    set::find(pdu, [&]<typename F>(std::type_identity<F>) {
        if constexpr (std::is_invocable_v<handler_type&, typename F::request const&>) {
            fault = F::request::check(pdu);
            if (fault.ok()) { given = detail::serve_function<F>(pdu, out, handler, is_broadcast); }
        }
    });
    if (is_broadcast) { return 0; }
    if (not fault.ok()) { given = detail::outcome{to_exception(fault)}; }
    if (given.exception == exception_code{}) { return given.size; }
    auto const refused = static_cast<function_code>(layout::function.load(pdu));
    return detail::write_response(exception_response{refused, given.exception}, out).size;
}

}  // namespace drivecodec::modbus
