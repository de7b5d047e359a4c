// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/platform.hpp>
#include <drivecodec/modbus/encapsulated_interface.hpp>
#include <drivecodec/modbus/exception.hpp>

#include <array>

namespace drivecodec::modbus {

namespace detail {

/// Functions that share code 43 tell themselves apart by their `mei`.
template <typename F>
concept has_mei = requires { F::mei; };

/// Code and, if there is one, MEI type: what makes two functions the same.
template <typename F>
[[nodiscard]] consteval int function_key()
{
    if constexpr (has_mei<F>) {
        return 0x1'0000 | (to_byte(F::code) << 8) | static_cast<int>(F::mei);
    } else {
        return to_byte(F::code);
    }
}

template <typename F, typename... Others>
[[nodiscard]] consteval bool is_unique()
{
    return ((function_key<F>() != function_key<Others>()) and ...);
}

template <typename... Functions>
struct all_unique;
template <>
struct all_unique<> {
    static constexpr bool holds = true;
};
template <typename First, typename... Rest>
struct all_unique<First, Rest...> {
    static constexpr bool holds = is_unique<First, Rest...>() and all_unique<Rest...>::holds;
};

}  // namespace detail

/// The one list of functions from which come the dispatch of requests and responses, the lengths that a stream reader
/// predicts, names, and a server's answer to what it does not serve. A user's own function joins like a public one.
template <function... Functions>
struct function_set {
    static_assert(detail::all_unique<Functions...>::holds, "a function_set holds each function once");

    static_assert(((to_byte(Functions::code) < exception_bit) and ...), "a function code is below 80h");

    template <function... More>
    using with = function_set<Functions..., More...>;

    //=== what a PDU is ===//

    /// The name of the function in `pdu`, of a request, a response or an exception; nullptr if it is not in the set.
    [[nodiscard]] static constexpr char const* name(bytes pdu) noexcept
    {
        char const* found = nullptr;
        static_cast<void>(((is<Functions>(pdu) and (found = Functions::name) != nullptr) or ...));
        return found;
    }

    /// The length of the request that begins with `pdu`. A function that is not in the set ends with silence.
    [[nodiscard]] static constexpr message_length request_length(bytes pdu) noexcept
    {
        if (exception_response::is_exception(pdu)) { return message_length::impossible(); }
        return length<direction::request>(pdu);
    }

    /// The length of the response that begins with `pdu`. Of a refusal of function 43 this is the short form's.
    [[nodiscard]] static constexpr message_length response_length(bytes pdu) noexcept
    {
        if (exception_response::is_exception(pdu)) { return message_length::exactly(exception_response::wire_size()); }
        return length<direction::response>(pdu);
    }

    /// Will there be a reply to this request? Also true for what is not a valid request: that gets an exception.
    [[nodiscard]] static constexpr bool expects_reply(bytes pdu) noexcept
    {
        return (expects_reply_of<Functions>(pdu) and ...);
    }

    //=== dispatch ===//

    /// Calls `visitor` with the std::type_identity of the function in `pdu`. Returns false if it is not in the set.
    template <typename Visitor>
    static constexpr bool find(bytes pdu, Visitor&& visitor) noexcept
    {
        return ((is<Functions>(pdu) and (visitor(std::type_identity<Functions>{}), true)) or ...);
    }

    /// Decodes the request in `pdu` and calls `visitor` with it, as its own type; gives what the visitor answers.
    ///
    /// The visitor's overload set is the feature list: what it has no overload for is `unsupported_function`, and none
    /// of that function's code is compiled. Other errors are those of the request's `check`.
    template <typename Answer, typename Visitor>
    [[nodiscard]] static constexpr result<Answer> visit_request(bytes pdu, Visitor&& visitor) noexcept
    {
        if (pdu.empty()) { return error{errc::truncated, 1}; }
        if (exception_response::is_exception(pdu)) { return unsupported; }
        result<Answer> answer{unsupported};
        find(pdu, [&]<typename F>(std::type_identity<F>) { visit<typename F::request>(pdu, visitor, answer); });
        return answer;
    }

    /// The same for a response; an exception comes as `exception_response`.
    template <typename Answer, typename Visitor>
    [[nodiscard]] static constexpr result<Answer> visit_response(bytes pdu, Visitor&& visitor) noexcept
    {
        if (pdu.empty()) { return error{errc::truncated, 1}; }
        result<Answer> answer{unsupported};
        if (exception_response::is_exception(pdu)) {
            visit<exception_response>(pdu, visitor, answer);
        } else {
            find(pdu, [&]<typename F>(std::type_identity<F>) { visit<typename F::response>(pdu, visitor, answer); });
        }
        return answer;
    }

private:
    static constexpr error unsupported{errc::unsupported_function, layout::function.begin};

    /// Which codes have a function: bit c % 64 of element c / 64.
    static constexpr std::array<std::uint64_t, 2> codes = [] {
        std::array<std::uint64_t, 2> known{};
        ((known[to_byte(Functions::code) / 64U % 2U] |= std::uint64_t{1} << to_byte(Functions::code) % 64U), ...);
        return known;
    }();

    template <typename F>
    [[nodiscard]] static constexpr bool is(bytes pdu) noexcept
    {
        if (pdu.empty() or (layout::function.load(pdu) & ~exception_bit) != to_byte(F::code)) { return false; }
        if constexpr (detail::has_mei<F>) {
            namespace at = layout::encapsulated_interface;
            return pdu.size() >= at::data and at::type.load(pdu) == static_cast<std::uint8_t>(F::mei);
        }
        return true;
    }

    template <typename F>
    [[nodiscard]] static constexpr bool expects_reply_of(bytes pdu) noexcept
    {
        if constexpr (requires { F::expects_reply(pdu); }) {
            return not is<F>(pdu) or F::expects_reply(pdu);
        } else {
            return true;
        }
    }

    template <direction Direction>
    [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
    {
        if (pdu.empty()) { return message_length::at_least(1); }
        if constexpr (is_host) {  // noise is mostly not a function
            auto const code = layout::function.load(pdu);
            if ((codes[code / 64U % 2U] >> code % 64U & 1U) == 0) { return message_length::until_silence(); }
        }
        auto found = message_length::until_silence();
        static_cast<void>((length_if<Functions, Direction>(pdu, found) or ...));
        return found;
    }

    template <typename F, direction Direction>
    [[nodiscard]] static constexpr bool length_if(bytes pdu, message_length& found) noexcept
    {
        if (layout::function.load(pdu) != to_byte(F::code)) { return false; }
        if constexpr (detail::has_mei<F>) {
            if (pdu.size() < layout::encapsulated_interface::data) {
                found = message_length::at_least(layout::encapsulated_interface::data);
                return true;
            }
            if (not is<F>(pdu)) { return false; }
        }
        if constexpr (Direction == direction::request) {
            found = F::request::length(pdu);
        } else {
            found = F::response::length(pdu);
        }
        return true;
    }

    template <typename Message, typename Visitor, typename Answer>
    static constexpr void visit(bytes pdu, Visitor& visitor, result<Answer>& answer) noexcept
    {
        if constexpr (std::is_invocable_v<Visitor&, Message const&>) {
            if (auto const fault = Message::check(pdu); not fault.ok()) {
                answer = fault;
            } else {
                answer = Answer(visitor(Message::read(pdu)));
            }
        }
    }
};

}  // namespace drivecodec::modbus
