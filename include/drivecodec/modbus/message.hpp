// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/codec.hpp>
#include <drivecodec/core/message_length.hpp>
#include <drivecodec/modbus/address_range.hpp>
#include <drivecodec/modbus/function_code.hpp>

// What every request and response has in common: it is a codec whose wire form is a PDU, it names its `function`,
// and it tells from its first bytes how long it is.

namespace drivecodec::modbus {

template <typename T>
concept message = writable<T> and requires { T::function::code; };

/// What may stand in a frame: a message, or what says `is_pdu` of itself.
template <typename T>
concept framable = writable<T> and (message<T> or requires { requires T::is_pdu; });

/// A message that can also be read. Its `length` looks at no more of the PDU than the header.
template <typename T>
concept readable_message = message<T> and codec<T> and requires(bytes pdu) {
    { T::length(pdu) } noexcept -> std::same_as<message_length>;
};

/// A request knows which responses answer it: `matches` finds the first field that differs from what was asked.
template <typename T>
concept request_message = readable_message<T> and requires(T const asked, typename T::function::response given) {
    { asked.matches(given) } noexcept -> std::same_as<error>;
};

/// A function joins sets, visitors, readers and servers by this alone; a user's own like the public ones.
template <typename F>
concept function = requires {
    { F::code } -> std::convertible_to<function_code>;
    { F::name } -> std::convertible_to<char const*>;
} and request_message<typename F::request> and readable_message<typename F::response>;

/// May the function's request be broadcast? Only those that write: `static constexpr bool is_write = true`.
template <typename F>
[[nodiscard]] constexpr bool is_write() noexcept
{
    if constexpr (requires { F::is_write; }) {
        return F::is_write;
    } else {
        return false;
    }
}

/// Does this request get a reply at all? A request that may not says so by a member `expects_reply()`, and its function
/// by a static one that takes the PDU.
template <message Request>
[[nodiscard]] constexpr bool expects_reply(Request const& asked) noexcept
{
    if constexpr (requires { asked.expects_reply(); }) {
        return asked.expects_reply();
    } else {
        return true;
    }
}

//=== rules that every PDU obeys ===//

namespace layout {
inline constexpr u8_at<0> function{};  // | function | ...
}

/// The function byte, then the header: `header` bytes are needed to go on, `least` by the shortest such message.
[[nodiscard]] constexpr error check_head(bytes pdu, function_code code, std::size_t header, std::size_t least) noexcept
{
    if (not pdu.empty() and layout::function.load(pdu) != to_byte(code)) {
        return {errc::unexpected_function, layout::function.begin};
    }
    return pdu.size() < header ? error{errc::truncated, least} : error{};
}

/// Exactly `size` bytes, neither fewer nor more.
[[nodiscard]] constexpr error check_size(bytes pdu, std::size_t size) noexcept
{
    if (pdu.size() < size) { return {errc::truncated, size}; }
    if (pdu.size() > size) { return {errc::trailing_bytes, size}; }
    return {};
}

/// Both, for a message of one size.
[[nodiscard]] constexpr error check_fixed(bytes pdu, function_code code, std::size_t size) noexcept
{
    auto const fault = check_head(pdu, code, size, size);
    return fault.ok() ? check_size(pdu, size) : fault;
}

/// The rules for two neighbouring fields, | first hi lo | count hi lo |. Precondition: pdu.size() >= offset + 4.
[[nodiscard]] constexpr error check_range_at(bytes pdu, std::size_t offset, std::uint16_t max) noexcept
{
    auto const fields = pdu.subspan(offset);
    return check_range(be16_at<0>::load(fields), be16_at<2>::load(fields), max).moved_by(offset);
}

/// What a request's `matches` says of a field that should have been another.
[[nodiscard]] constexpr error expect_equal(bool equal, std::size_t offset) noexcept
{
    return equal ? error{} : error{errc::unexpected_reply, offset};
}

}  // namespace drivecodec::modbus
