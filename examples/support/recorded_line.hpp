// SPDX-License-Identifier: MIT
#pragma once

#include "ear.hpp"
#include "hex.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

namespace support {

/// A line of a recorded file: bytes that were heard between two silences, and perhaps when.
///
///     12.345678 01 03 00 6B 00 03 74 17     # seconds, always with six digits behind the point, then hexadecimal
///     01 03 00 6B 00 03 74 17
struct recorded_line {
    std::optional<timestamp> time;
    parsed_hex               heard;  ///< Its column counts from the begin of the line.
};

[[nodiscard]] inline recorded_line parse_recorded(std::string_view line)
{
    constexpr std::size_t most_seconds = 12;  // digits: a time in microseconds fits into 64 bits
    constexpr std::size_t fraction     = 6;
    constexpr auto        blanks       = std::string_view{" \t\r"};

    auto const is_digit = [](char c) { return c >= '0' and c <= '9'; };
    auto const begin    = std::min(line.find_first_not_of(blanks), line.size());
    auto const word     = line.substr(begin, std::min(line.find_first_of(blanks, begin), line.size()) - begin);
    auto const point    = word.find('.');
    auto const is_time  = point != std::string_view::npos and point >= 1 and point <= most_seconds
                         and word.size() == point + 1 + fraction
                         and std::ranges::all_of(word.substr(0, point), is_digit)
                         and std::ranges::all_of(word.substr(point + 1), is_digit);
    if (not is_time) { return {.time = std::nullopt, .heard = parse_hex(line)}; }

    timestamp time = 0;
    for (auto const c : word) {
        if (c != '.') { time = time * 10 + static_cast<timestamp>(c - '0'); }
    }
    auto const    behind = begin + word.size();
    recorded_line parsed{.time = time, .heard = parse_hex(line.substr(behind))};
    if (parsed.heard.column != 0) { parsed.heard.column += behind; }
    return parsed;
}

}  // namespace support
