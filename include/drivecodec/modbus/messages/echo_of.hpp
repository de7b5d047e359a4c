// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/message.hpp>

namespace drivecodec::modbus {

/// A response that repeats its request: the same fields and the same wire form, but a type of its own, so that a
/// visitor knows which of the two it has.
template <typename Request>
struct echo_of : Request {
    [[nodiscard]] static constexpr echo_of read(bytes pdu) noexcept { return {Request::read(pdu)}; }

    friend constexpr bool operator==(echo_of const&, echo_of const&) noexcept = default;
};

}  // namespace drivecodec::modbus
