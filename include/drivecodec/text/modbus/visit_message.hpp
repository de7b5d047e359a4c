// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/coil_view.hpp>
#include <drivecodec/modbus/function_set.hpp>

namespace drivecodec::modbus {

/// The response, with what only its request knows: how many coils were asked for. A response has whole bytes of them.
///
/// What does not answer the request, and what has nothing to learn from it, comes back as it is.
template <message Request, message Response>
[[nodiscard]] constexpr Response in_the_light_of(Request const& asked, Response const& given) noexcept
{
    if constexpr (requires { asked.range.count(), given.values.values().first(1); }) {
        if (not asked.matches(given).ok()) { return given; }
        using values = typename Response::bounded_values;
        return {.values = values::from_checked(given.values.values().first(asked.range.count()))};
    } else {
        return given;
    }
}

/// Decodes `pdu` and calls `visitor` with the message, whatever its type; exceptions are `exception_response`.
///
/// A response is read in the light of `request`, the request PDU that was heard before it, if there is one. Errors are
/// those of `Functions::visit_request` and `visit_response`, and then the visitor is not called.
template <typename Functions, typename Visitor>
[[nodiscard]] constexpr error visit_message(direction which, bytes pdu, bytes request, Visitor&& visitor) noexcept
{
    if (which == direction::request) {
        auto const asked = Functions::template visit_request<bool>(pdu, [&](auto const& message) {
            visitor(message);
            return true;
        });
        return asked ? error{} : asked.error();
    }

    auto const given = Functions::template visit_response<bool>(pdu, [&]<typename Response>(Response const& message) {
        if constexpr (requires { typename Response::function::request; }) {
            using asked = typename Response::function::request;
            if (asked::check(request).ok()) {
                visitor(in_the_light_of(asked::read(request), message));
                return true;
            }
        }
        visitor(message);
        return true;
    });
    return given ? error{} : given.error();
}

}  // namespace drivecodec::modbus
