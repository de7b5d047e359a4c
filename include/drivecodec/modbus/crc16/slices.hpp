// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/crc16/table.hpp>

#include <utility>

namespace drivecodec::modbus::crc16 {

/// Entry [n][i]: what byte i does to the remainder when n more bytes follow it in the slice.
[[nodiscard]] consteval std::array<std::array<std::uint16_t, 256>, 8> make_slice_entries()
{
    std::array<std::array<std::uint16_t, 256>, 8> entries{make_table<8>()};
    for (std::size_t n = 1; n < entries.size(); ++n) {
        for (std::size_t i = 0; i < 256; ++i) {
            auto const before = entries[n - 1][i];
            entries[n][i]     = static_cast<std::uint16_t>((before >> 8) ^ entries[0][before & 0xFFU]);
        }
    }
    return entries;
}

inline constexpr std::array<std::array<std::uint16_t, 256>, 8> slice_entries = make_slice_entries();

/// Eight bytes at a time, with tables of 4 KiB: for machines with a cache. The look-ups of one slice do not wait for
/// each other (M. Kounavis, F. Berry: "Novel Table Lookup-Based Algorithms for High-Performance CRC Generation", 2008).
///
/// Reads byte by byte: neither alignment nor the machine's byte order matters.
class slices {
    /// The remainder after a slice of `Size` bytes, at least two: its own two bytes meet the first two of the slice.
    template <std::size_t Size>
    [[nodiscard]] static constexpr std::uint32_t after(std::uint32_t remainder, std::uint8_t const* from) noexcept
    {
        auto const first  = slice_entries[Size - 1][(remainder ^ from[0]) & 0xFFU];
        auto const second = slice_entries[Size - 2][((remainder >> 8) ^ from[1]) & 0xFFU];
        return [&]<std::size_t... I>(std::index_sequence<I...>) {
            return (std::uint32_t{0} ^ ... ^ slice_entries[Size - 3 - I][from[2 + I]]) ^ (first ^ second);
        }(std::make_index_sequence<Size - 2>{});
    }

public:
    [[nodiscard]] static constexpr std::uint16_t update(std::uint16_t crc, bytes data) noexcept
    {
        auto const*   from      = data.data();
        auto          left      = data.size();
        std::uint32_t remainder = crc;
        for (; left >= 8; left -= 8) {
            remainder = after<8>(remainder, from);
            from += 8;
        }
        if ((left & 4U) != 0) {
            remainder = after<4>(remainder, from);
            from += 4;
        }
        if ((left & 2U) != 0) {
            remainder = after<2>(remainder, from);
            from += 2;
        }
        if ((left & 1U) != 0) { remainder = (remainder >> 8) ^ slice_entries[0][(remainder ^ *from) & 0xFFU]; }
        return static_cast<std::uint16_t>(remainder);
    }
};

}  // namespace drivecodec::modbus::crc16
