// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace support {

/// Bytes as people write and copy them, or what is wrong with them.
struct parsed_hex {
    std::vector<std::uint8_t> bytes;
    std::size_t               column = 0;  ///< 0, or the character, counted from 1, at which it went wrong.
    std::string               problem;
};

/// One line of hexadecimal. Bytes have one or two digits, or stand together: `1 3 0x00 6B`, `01,03,00,6B`, `0103:006b`,
/// `\x01\x03`, `01h 03h`. Blanks and punctuation separate; `#` begins a comment.
[[nodiscard]] parsed_hex parse_hex(std::string_view line);

/// Two digits a byte, nothing between.
[[nodiscard]] std::string to_hex(drivecodec::bytes raw);

}  // namespace support
