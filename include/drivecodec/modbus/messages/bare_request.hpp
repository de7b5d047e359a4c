// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/message.hpp>

namespace drivecodec::modbus {

/// A request that is its function code alone: 07, 11, 12, 17.
template <typename Function>
struct bare_request {
    using function = Function;

    [[nodiscard]] static constexpr std::size_t    wire_size() noexcept { return layout::function.end; }
    [[nodiscard]] static constexpr message_length length(bytes) noexcept
    {
        return message_length::exactly(wire_size());
    }
    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        return check_fixed(pdu, Function::code, wire_size());
    }
    [[nodiscard]] static constexpr bare_request read(bytes) noexcept { return {}; }

    constexpr void write(mutable_bytes out) const noexcept { layout::function.store(out, to_byte(Function::code)); }

    /// Every response of the function answers it.
    [[nodiscard]] constexpr error matches(auto const&) const noexcept { return {}; }

    friend constexpr bool operator==(bare_request const&, bare_request const&) noexcept = default;
};

}  // namespace drivecodec::modbus
