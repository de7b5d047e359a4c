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

[[nodiscard]] constexpr std::size_t write_exception(function_code refused, exception_code code, mutable_bytes out) noexcept
{
    auto const written = encode(exception_response{.refused = refused, .code = code}, out);
    return written ? written->size() : 0;
}

template <typename T>
inline constexpr bool is_answer = false;
template <typename T>
inline constexpr bool is_answer<result<T, exception_code>> = true;

/// Writes the reply that `given` stands for; a reply that does not fit, or does not answer `asked`, becomes exception 04.
template <typename Request, typename Given>
[[nodiscard]] constexpr std::size_t write_reply(Request const& asked, Given const& given, mutable_bytes out) noexcept
{
    constexpr auto code = Request::function::code;
    if constexpr (std::is_same_v<Given, exception_code>) {
        return write_exception(code, given, out);
    } else if constexpr (is_answer<Given>) {
        return given ? write_reply(asked, *given, out) : write_exception(code, given.error(), out);
    } else if constexpr (std::is_same_v<Given, done>) {
        return write_reply(asked, asked.reply(), out);
    } else if constexpr (message<Given>) {
        if (asked.matches(given).ok()) {
            if (auto const written = encode(given, out); written) { return written->size(); }
        }
        return write_exception(code, exception_code::server_device_failure, out);
    } else {
        auto const made = Request::function::response::make(given);
        if constexpr (requires { made.has_value(); }) {
            return made ? write_reply(asked, *made, out)
                        : write_exception(code, exception_code::server_device_failure, out);
        } else {
            return write_reply(asked, made, out);
        }
    }
}

/// Hands a request to the handler and writes what it answers. Has no overload for what the handler has none for.
template <typename Handler>
struct responder {
    Handler&      handler;
    mutable_bytes out;
    bool          is_broadcast;

    template <typename Request>
        requires std::is_invocable_v<Handler&, Request const&>
    [[nodiscard]] constexpr std::uint16_t operator()(Request const& asked) const noexcept
    {
        if (is_broadcast) {
            if constexpr (is_write<typename Request::function>()) { static_cast<void>(handler(asked)); }
            return 0;
        }
        auto const given = handler(asked);
        return expects_reply(asked) ? static_cast<std::uint16_t>(write_reply(asked, given, out)) : std::uint16_t{0};
    }
};

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
    using set       = typename detail::served<Functions, std::remove_cvref_t<Handler>>::type;
    using responder = detail::responder<std::remove_reference_t<Handler>>;

    if (pdu.empty() or exception_response::is_exception(pdu)) { return 0; }
    out             = out.first(out.size() < max_pdu_size ? out.size() : max_pdu_size);
    auto const size = set::template visit_request<std::uint16_t>(pdu, responder{handler, out, is_broadcast});
    if (size or is_broadcast) { return size.value_or(0); }
    auto const refused = static_cast<function_code>(layout::function.load(pdu));
    return detail::write_exception(refused, to_exception(size.error()), out);
}

}  // namespace drivecodec::modbus
