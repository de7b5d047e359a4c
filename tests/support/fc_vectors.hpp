#pragma once

#include "support/hex.hpp"

#include <span>

/// FC telegrams. The blocks named after an example are those that the VLT 6000 manual prints; STX, LGE, ADR and BCC
/// were put around them by hand, BCC from left to right: 02 ^ 0E = 0C, ^ 01 = 0D ...
namespace vectors {

//=== "Example - Read a parameter value": 206; the reply is 10 s, with the process block of the status example ===//

inline constexpr auto read_206          = "02 0E 01 10 CE 00 00 00 00 00 00 00 00 00 00 D3"_hex;
inline constexpr auto read_206_response = "02 0E 01 10 CE 00 00 00 00 00 0A 0F 03 20 00 F5"_hex;

//=== "Example - Write a parameter value": 202 = 100 Hz in EEPROM, with the process block of the control example ===//

inline constexpr auto write_202          = "02 0E 01 E0 CA 00 00 00 00 03 E8 04 7F 20 00 97"_hex;
inline constexpr auto write_202_response = "02 0E 01 10 CA 00 00 00 00 03 E8 0F 03 20 00 10"_hex;

//=== "Example - Choice of a data value": 415 = [20] in EEPROM ===//

inline constexpr auto write_415          = "02 0E 01 E1 9F 00 00 00 00 00 14 00 00 00 00 67"_hex;
inline constexpr auto write_415_response = "02 0E 01 11 9F 00 00 00 00 00 14 0F 03 20 00 BB"_hex;

//=== "Example - Index": 615 [1]; the reply has error code 13, of 1 to 99 ===//

inline constexpr auto read_615_1          = "02 0E 01 12 67 00 01 00 00 00 00 00 00 00 00 79"_hex;
inline constexpr auto read_615_1_response = "02 0E 01 12 67 00 01 00 00 00 0D 0F 03 20 00 58"_hex;

//=== process data as in the examples of control word and status word; to 22, as in "ADR", and to all ===//

inline constexpr auto forwards_to_22         = "02 06 16 04 7F 20 00 49"_hex;
inline constexpr auto backwards_to_22        = "02 06 16 04 7F E0 00 89"_hex;
inline constexpr auto status_of_22           = "02 06 16 0F 03 20 00 3E"_hex;
inline constexpr auto backwards_to_all_short = "02 06 20 04 7F E0 00 BF"_hex;
inline constexpr auto backwards_to_all_long  = "02 06 80 04 7F E0 00 1F"_hex;

//=== texts: 621 reads "VLT6000", 533 is to be "HELLO" ===//

inline constexpr auto read_621          = "02 0E 81 F2 6D 04 00 00 00 00 00 00 00 00 00 16"_hex;
inline constexpr auto read_621_response = "02 11 81 F2 6D 04 00 56 4C 54 36 30 30 30 0F 03 20 00 6D"_hex;
inline constexpr auto write_533         = "02 0F 81 F2 15 05 00 48 45 4C 4C 4F 00 00 00 00 2C"_hex;

//=== 501 = 5 in EEPROM: 130, "there is no bus access to the parameter called" ===//

inline constexpr auto write_501          = "02 0E 01 E1 F5 00 00 00 00 00 05 00 00 00 00 1C"_hex;
inline constexpr auto write_501_response = "02 0E 01 71 F5 00 00 00 00 00 82 0F 03 20 00 27"_hex;

//=== a double word, 00012345h, into an element of an array in EEPROM ===//

inline constexpr auto write_291_1          = "02 0E 01 D1 23 00 01 00 01 23 45 00 00 00 00 99"_hex;
inline constexpr auto write_291_1_response = "02 0E 01 21 23 00 01 00 01 23 45 0F 03 20 00 45"_hex;

using telegram = std::span<std::uint8_t const>;

inline constexpr std::array<telegram, 20> all_fc{
    read_206,
    read_206_response,
    write_202,
    write_202_response,
    write_415,
    write_415_response,
    read_615_1,
    read_615_1_response,
    forwards_to_22,
    backwards_to_22,
    status_of_22,
    backwards_to_all_short,
    backwards_to_all_long,
    read_621,
    read_621_response,
    write_533,
    write_501,
    write_501_response,
    write_291_1,
    write_291_1_response,
};

}  // namespace vectors
