// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/crc16/table.hpp>

namespace drivecodec::modbus::crc16 {

inline constexpr std::array<std::uint16_t, 256> byte_entries = make_table<8>();

/// Eight bits at a time, with a table of 512 bytes: what most Modbus implementations use.
struct byte_table {
    [[nodiscard]] static constexpr std::uint16_t update(std::uint16_t crc, bytes data) noexcept
    {
        std::uint32_t remainder = crc;
        for (auto const byte : data) { remainder = (remainder >> 8) ^ byte_entries[(remainder ^ byte) & 0xFFU]; }
        return static_cast<std::uint16_t>(remainder);
    }
};

}  // namespace drivecodec::modbus::crc16
