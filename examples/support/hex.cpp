// SPDX-License-Identifier: MIT
#include "hex.hpp"

#include <drivecodec/text/writer.hpp>

namespace support {

namespace {

constexpr int digit_of(char c)
{
    if (c >= '0' and c <= '9') { return c - '0'; }
    if (c >= 'a' and c <= 'f') { return c - 'a' + 10; }
    if (c >= 'A' and c <= 'F') { return c - 'A' + 10; }
    return -1;
}

constexpr bool is_either(char c, char lower, char upper)
{
    return c == lower or c == upper;
}

constexpr bool is_separator(char c)
{
    auto const is_letter = (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z');
    return c == '\t' or c == '\r' or c == '\n' or c == '\v' or c == '\f' or (c >= ' ' and c <= '~' and not is_letter);
}

std::string quoted(char c)
{
    if (c >= ' ' and c <= '~') { return {'\'', c, '\''}; }
    auto const byte = static_cast<std::uint8_t>(c);
    return "byte 0x" + to_hex({&byte, 1});
}

}  // namespace

parsed_hex parse_hex(std::string_view line)
{
    parsed_hex parsed;
    auto const refuse = [&](std::size_t at, std::string problem) {
        parsed.column  = at + 1;
        parsed.problem = std::move(problem);
        return parsed;
    };

    line = line.substr(0, line.find('#'));
    for (std::size_t at = 0; at < line.size();) {
        auto const has_prefix = at + 1 < line.size() and (line[at] == '0' or line[at] == '\\')
                                and is_either(line[at + 1], 'x', 'X');
        if (has_prefix) {
            at += 2;
            if (at == line.size() or digit_of(line[at]) < 0) { return refuse(at - 2, "no digits behind the prefix"); }
        }
        auto const first = at;
        while (at < line.size() and digit_of(line[at]) >= 0) { ++at; }

        auto digits = line.substr(first, at - first);
        if (digits.empty()) {
            if (not is_separator(line[at])) { return refuse(at, quoted(line[at]) + " is not a hexadecimal digit"); }
            ++at;
            continue;
        }
        if (at < line.size() and is_either(line[at], 'h', 'H')) { ++at; }  // as the manuals write: 0Dh

        if (digits.size() == 1) {
            parsed.bytes.push_back(static_cast<std::uint8_t>(digit_of(digits[0])));
        } else if (digits.size() % 2 != 0) {
            return refuse(first, "an odd number of digits: '" + std::string{digits} + "'");
        } else {
            for (; not digits.empty(); digits.remove_prefix(2)) {
                parsed.bytes.push_back(static_cast<std::uint8_t>(digit_of(digits[0]) * 16 + digit_of(digits[1])));
            }
        }
    }
    return parsed;
}

std::string to_hex(drivecodec::bytes raw)
{
    std::string text(2 * raw.size(), '0');
    drivecodec::text_writer{text}.hex(raw, "");
    return text;
}

}  // namespace support
