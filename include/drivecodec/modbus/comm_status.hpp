// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::modbus {

/// The status word of Get Comm Event Counter and Log: is a program command still being processed? There are only two.
/// MODBUS Application Protocol V1.1b3, 6.9.
struct comm_status {
    static constexpr std::uint16_t busy  = 0xFFFF;
    static constexpr std::uint16_t ready = 0x0000;

    [[nodiscard]] static constexpr bool is_valid(std::uint16_t wire) noexcept { return wire == busy or wire == ready; }
    [[nodiscard]] static constexpr std::uint16_t to_wire(bool is_busy) noexcept { return is_busy ? busy : ready; }
};

}  // namespace drivecodec::modbus
