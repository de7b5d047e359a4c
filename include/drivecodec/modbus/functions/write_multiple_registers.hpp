// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/messages/block_request.hpp>
#include <drivecodec/modbus/register_view.hpp>

namespace drivecodec::modbus {

/// Write Multiple Registers (16), MODBUS Application Protocol V1.1b3, 6.12: 1 to `Max` consecutive registers.
template <std::uint16_t Max>
struct basic_write_multiple_registers {
    static_assert(Max >= 1 and Max <= 123, "a request holds at most 123 registers");

    static constexpr auto        code     = function_code::write_multiple_registers;
    static constexpr char const* name     = "write_multiple_registers";
    static constexpr bool        is_write = true;

    template <typename Values>
    using basic_request = block_request<basic_write_multiple_registers, Values, Max>;
    using request       = basic_request<register_view>;
    using response      = typename request::response;

    /// A constant request, checked by the compiler: `of(0x0001, {0x000A, 0x0102})`.
    template <std::size_t N>
    [[nodiscard]] static consteval basic_request<register_array<N>> of(int first, std::uint16_t const (&words)[N])
    {
        return {.block = {first, {std::to_array(words)}}};
    }
};
using write_multiple_registers = basic_write_multiple_registers<123>;

}  // namespace drivecodec::modbus
