// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/platform.hpp>
#include <drivecodec/modbus/crc16/bitwise.hpp>
#include <drivecodec/modbus/crc16/slices.hpp>

#include <concepts>

/// CRC-16/MODBUS: MODBUS over Serial Line V1.02, 2.5.1.2 and 6.2.2. Polynomial 8005h reflected, no final exclusive-or,
/// sent low byte first.
namespace drivecodec::modbus::crc16 {

/// The remainder that a message begins with.
inline constexpr std::uint16_t initial = 0xFFFF;

/// The CRC of a message with its own CRC behind it, low byte first.
inline constexpr std::uint16_t residue = 0;

/// A way to compute the CRC; all give the same. `update` continues a CRC with more bytes.
///
/// | algorithm    | table | time | for                                                                            |
/// |--------------|-------|------|--------------------------------------------------------------------------------|
/// | `bitwise`    | none  |  100 | the smallest code; the default of firmware                                     |
/// | `nibble`     | 32 B  |   59 | firmware on a fast line                                                        |
/// | `byte_table` | 512 B |   31 | firmware with flash to spare                                                   |
/// | `slices`     | 4 KiB |    5 | machines with a cache; the default of hosts                                    |
/// | `carryless`  | 4 KiB |    1 | hosts whose target has a carry-less multiply (-mpclmul, -march=armv8-a+crypto) |
///
/// Times are those of 256 bytes on one x86-64 (bench/modbus/crc16.cpp), in percent. `bitwise` and `slices` come with
/// this header; the others have theirs in <drivecodec/modbus/crc16/>. A table is linked only into what uses it. An
/// algorithm of your own, perhaps a peripheral of the processor, needs nothing but `update`.
template <typename T>
concept algorithm = requires(std::uint16_t crc, bytes data) {
    { T::update(crc, data) } noexcept -> std::same_as<std::uint16_t>;
};

/// What is used where none is named.
using by_default = std::conditional_t<is_host, slices, bitwise>;

/// The CRC of `data`.
template <algorithm Algorithm = by_default>
[[nodiscard]] constexpr std::uint16_t compute(bytes data) noexcept
{
    return Algorithm::update(initial, data);
}

}  // namespace drivecodec::modbus::crc16
