// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>

namespace drivecodec::modbus::crc16 {

/// x^16 + x^15 + x^2 + 1 with all 17 coefficients, reflected as in a serial line's bit order: bit 0 is that of x^16.
/// MODBUS over Serial Line V1.02, 6.2.2; without bit 0 and shifted it is the A001h that is printed there.
inline constexpr std::uint32_t polynomial = 0x14003;

/// Bit by bit: no table and the smallest code, for firmware with few and short messages.
///
/// What the other algorithms must equal, and what their tables are made of.
struct bitwise {
    [[nodiscard]] static constexpr std::uint16_t update(std::uint16_t crc, bytes data) noexcept
    {
        std::uint32_t remainder = crc;
        for (auto const byte : data) {
            remainder ^= byte;
            for (int bit = 0; bit < 8; ++bit) {
                if ((remainder & 1U) != 0) { remainder ^= polynomial; }
                remainder >>= 1;
            }
        }
        return static_cast<std::uint16_t>(remainder);
    }
};

}  // namespace drivecodec::modbus::crc16
