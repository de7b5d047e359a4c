// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/coil_view.hpp>
#include <drivecodec/modbus/messages/block_request.hpp>

namespace drivecodec::modbus {

/// Write Multiple Coils (15), MODBUS Application Protocol V1.1b3, 6.11: 1 to `Max` consecutive coils.
template <std::uint16_t Max>
struct basic_write_multiple_coils {
    static_assert(Max >= 1 and Max <= 1968, "a request holds at most 1968 coils");

    static constexpr auto        code     = function_code::write_multiple_coils;
    static constexpr char const* name     = "write_multiple_coils";
    static constexpr bool        is_write = true;

    template <typename Values>
    using basic_request = block_request<basic_write_multiple_coils, Values, Max>;
    using request       = basic_request<coil_view>;
    using response      = typename request::response;

    /// A constant request, checked by the compiler: `of(19, {true, false, true})`.
    template <std::size_t N>
    [[nodiscard]] static consteval basic_request<coil_array<N>> of(int first, bool const (&states)[N])
    {
        return {.block = {first, {std::to_array(states)}}};
    }
};
using write_multiple_coils = basic_write_multiple_coils<1968>;

}  // namespace drivecodec::modbus
