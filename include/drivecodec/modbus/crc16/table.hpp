// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/crc16/bitwise.hpp>

#include <array>

namespace drivecodec::modbus::crc16 {

/// `crc` after `count` more bytes, all zero: multiplied by x^(8 * count), modulo the polynomial.
[[nodiscard]] consteval std::uint16_t after_zeros(std::uint16_t crc, std::size_t count)
{
    constexpr std::array<std::uint8_t, 1> zero{};
    for (; count > 0; --count) { crc = bitwise::update(crc, zero); }
    return crc;
}

/// What the low `Bits` bits of the remainder do to the rest of it while they are shifted out, for each of their values.
template <unsigned Bits>
[[nodiscard]] consteval std::array<std::uint16_t, (1U << Bits)> make_table()
{
    static_assert(Bits >= 1 and Bits <= 8);
    std::array<std::uint16_t, (1U << Bits)> table{};
    for (unsigned low_bits = 0; low_bits < table.size(); ++low_bits) {
        // Of the eight bits of a zero byte the first 8 - Bits only bring low_bits down to bit 0.
        table[low_bits] = after_zeros(static_cast<std::uint16_t>(low_bits << (8 - Bits)), 1);
    }
    return table;
}

}  // namespace drivecodec::modbus::crc16
