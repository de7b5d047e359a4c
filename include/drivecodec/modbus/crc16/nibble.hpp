// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/crc16/table.hpp>

namespace drivecodec::modbus::crc16 {

inline constexpr std::array<std::uint16_t, 16> nibble_entries = make_table<4>();

/// Four bits at a time, with a table of 32 bytes: for firmware where `bitwise` is too slow and 512 bytes are too many.
struct nibble {
    [[nodiscard]] static constexpr std::uint16_t update(std::uint16_t crc, bytes data) noexcept
    {
        std::uint32_t remainder = crc;
        for (auto const byte : data) {
            remainder ^= byte;
            remainder = (remainder >> 4) ^ nibble_entries[remainder & 15U];
            remainder = (remainder >> 4) ^ nibble_entries[remainder & 15U];
        }
        return static_cast<std::uint16_t>(remainder);
    }
};

}  // namespace drivecodec::modbus::crc16
