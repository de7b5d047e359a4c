// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/functions/diagnostics.hpp>
#include <drivecodec/modbus/functions/read_bits.hpp>
#include <drivecodec/modbus/functions/read_fifo_queue.hpp>
#include <drivecodec/modbus/functions/read_write_multiple_registers.hpp>
#include <drivecodec/modbus/messages/block_request.hpp>
#include <drivecodec/text/modbus/diagnostic.hpp>

// The fields of messages that carry runs of registers, coils or inputs: 01 to 04, 08, 15, 16, 23, 24.

namespace drivecodec::modbus {

namespace detail {

[[nodiscard]] constexpr register_view const& view_of(register_view const& values) noexcept
{
    return values;
}
[[nodiscard]] constexpr coil_view const& view_of(coil_view const& values) noexcept
{
    return values;
}
template <std::size_t N>
[[nodiscard]] constexpr register_view view_of(register_array<N> const& values) noexcept
{
    return values.words;
}
template <std::size_t N>
[[nodiscard]] constexpr coil_view view_of(coil_array<N> const& values) noexcept
{
    return values.states;
}

/// What the values of a function are called.
template <typename Function, typename Values>
[[nodiscard]] consteval char const* values_name() noexcept
{
    if (Function::code == function_code::read_discrete_inputs) { return "inputs"; }
    return std::is_same_v<typename Values::addressed, registers> ? "registers" : "coils";
}

[[nodiscard]] constexpr std::uint8_t byte_count_of(auto const& values) noexcept
{
    return static_cast<std::uint8_t>(values.wire_size());
}

}  // namespace detail

//=== shapes that functions have in common ===//

template <typename Function, typename Range>
constexpr void for_each_field(range_message<Function, Range> const& message, auto&& visit)
{
    visit("first", message.range.first());
    visit("count", message.range.count());
}

template <typename Function, typename Values, std::uint16_t Max>
constexpr void for_each_field(values_response<Function, Values, Max> const& given, auto&& visit)
{
    visit("byte_count", detail::byte_count_of(given.values));
    visit(detail::values_name<Function, Values>(), detail::view_of(given.values));
}

template <typename Function, typename Values, std::uint16_t Max>
constexpr void for_each_field(block_request<Function, Values, Max> const& asked, auto&& visit)
{
    visit("first", asked.block.first());
    visit("count", asked.block.count());
    visit("byte_count", detail::byte_count_of(asked.block.values()));
    visit(detail::values_name<Function, Values>(), detail::view_of(asked.block.values()));
}

//=== functions ===//

template <direction Direction, typename Values>
constexpr void for_each_field(diagnostics::message<Direction, Values> const& message, auto&& visit)
{
    visit("sub_function", message.sub_function());
    visit("data", detail::view_of(message.data()));
}

/// The request 23, of whatever limits.
template <typename Request>
    requires requires(Request const& asked) { asked.read_range, asked.write_block; }
constexpr void for_each_field(Request const& asked, auto&& visit)
{
    visit("read_first", asked.read_range.first());
    visit("read_count", asked.read_range.count());
    visit("write_first", asked.write_block.first());
    visit("write_count", asked.write_block.count());
    visit("byte_count", detail::byte_count_of(asked.write_block.values()));
    visit("registers", detail::view_of(asked.write_block.values()));
}

constexpr void for_each_field(read_fifo_queue::request const& asked, auto&& visit)
{
    visit("fifo_pointer_address", asked.address);
}

template <typename Values>
constexpr void for_each_field(read_fifo_queue::basic_response<Values> const& given, auto&& visit)
{
    namespace at = layout::read_fifo_queue_response;
    visit("byte_count", static_cast<std::uint16_t>(given.wire_size() - at::byte_count.end));
    visit("fifo_count", static_cast<std::uint16_t>(given.values.size()));
    visit("registers", detail::view_of(given.values));
}

}  // namespace drivecodec::modbus
