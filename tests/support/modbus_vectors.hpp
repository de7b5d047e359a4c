#pragma once

#include <array>
#include <cstdint>

/// Frames that others printed, with their CRC in wire order.
namespace vectors {

/// "123456789": the input of the check values in the catalogue of parametrised CRC algorithms.
inline constexpr std::array<std::uint8_t, 9> crc_check_input{0x31, 0x32, 0x33, 0x34, 0x35, 0x36, 0x37, 0x38, 0x39};

/// The catalogue's check value of CRC-16/MODBUS.
inline constexpr std::uint16_t crc_check = 0x4B37;

/// xD1000 manual.
inline constexpr std::array<std::uint8_t, 8>  xd1000_read_request{0x02, 0x03, 0x0C, 0x1E, 0x00, 0x04, 0x27, 0x6C};
inline constexpr std::array<std::uint8_t, 13> xd1000_read_response{0x02, 0x03, 0x08, 0x00, 0x28, 0x02, 0x58,
                                                                   0x01, 0xF4, 0x00, 0x00, 0x52, 0xB0};
inline constexpr std::array<std::uint8_t, 8>  xd1000_write_request{0x02, 0x06, 0x23, 0x29, 0x00, 0x0D, 0x92, 0x70};

/// The read of holding registers 40108 to 40110 of server 17 that most introductions to Modbus show.
inline constexpr std::array<std::uint8_t, 8> introduction_read_request{0x11, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x76, 0x87};

}  // namespace vectors
