// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/messages/range_message.hpp>
#include <drivecodec/modbus/messages/values_response.hpp>
#include <drivecodec/modbus/register_view.hpp>

namespace drivecodec::modbus {

/// Read Holding Registers (03), MODBUS Application Protocol V1.1b3, 6.3: the values of 1 to `Max` registers.
template <std::uint16_t Max>
struct basic_read_holding_registers {
    static_assert(Max >= 1 and Max <= 125, "a response holds at most 125 registers");

    static constexpr auto        code = function_code::read_holding_registers;
    static constexpr char const* name = "read_holding_registers";

    using request = range_message<basic_read_holding_registers, register_range<Max>>;
    template <typename Values>
    using basic_response = values_response<basic_read_holding_registers, Values, Max>;
    using response       = basic_response<register_view>;
};
using read_holding_registers = basic_read_holding_registers<125>;

/// Read Input Registers (04), MODBUS Application Protocol V1.1b3, 6.4: the values of 1 to `Max` input registers.
template <std::uint16_t Max>
struct basic_read_input_registers {
    static_assert(Max >= 1 and Max <= 125, "a response holds at most 125 registers");

    static constexpr auto        code = function_code::read_input_registers;
    static constexpr char const* name = "read_input_registers";

    using request = range_message<basic_read_input_registers, register_range<Max>>;
    template <typename Values>
    using basic_response = values_response<basic_read_input_registers, Values, Max>;
    using response       = basic_response<register_view>;
};
using read_input_registers = basic_read_input_registers<125>;

}  // namespace drivecodec::modbus
