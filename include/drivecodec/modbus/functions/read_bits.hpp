// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/coil_view.hpp>
#include <drivecodec/modbus/messages/range_message.hpp>
#include <drivecodec/modbus/messages/values_response.hpp>

namespace drivecodec::modbus {

/// Read Coils (01), MODBUS Application Protocol V1.1b3, 6.1: the states of 1 to `Max` coils.
template <std::uint16_t Max>
struct basic_read_coils {
    static_assert(Max >= 1 and Max <= 2000, "a response holds at most 2000 coils");

    static constexpr auto        code = function_code::read_coils;
    static constexpr char const* name = "read_coils";

    using request = range_message<basic_read_coils, coil_range<Max>>;
    template <typename Values>
    using basic_response = values_response<basic_read_coils, Values, Max>;
    using response       = basic_response<coil_view>;
};
using read_coils = basic_read_coils<2000>;

/// Read Discrete Inputs (02), MODBUS Application Protocol V1.1b3, 6.2: the states of 1 to `Max` inputs.
template <std::uint16_t Max>
struct basic_read_discrete_inputs {
    static_assert(Max >= 1 and Max <= 2000, "a response holds at most 2000 inputs");

    static constexpr auto        code = function_code::read_discrete_inputs;
    static constexpr char const* name = "read_discrete_inputs";

    using request = range_message<basic_read_discrete_inputs, coil_range<Max>>;
    template <typename Values>
    using basic_response = values_response<basic_read_discrete_inputs, Values, Max>;
    using response       = basic_response<coil_view>;
};
using read_discrete_inputs = basic_read_discrete_inputs<2000>;

}  // namespace drivecodec::modbus
