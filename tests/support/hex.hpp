#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// Bytes as the specifications print them: `"03 00 6B 00 03"_hex` is a std::array of five bytes.
namespace hex_literal {

template <std::size_t N>
struct text {
    char characters[N]{};

    consteval text(char const (&from)[N])
    {
        for (std::size_t i = 0; i < N; ++i) { characters[i] = from[i]; }
    }
};

void hexadecimal_digits_are_0_to_9_and_A_to_F();  // not constexpr: its name is the error text

/// 0 to 15, or -1 for a blank and the final zero.
constexpr int digit(char c)
{
    if (c == ' ' or c == '\0') { return -1; }
    if (c >= '0' and c <= '9') { return c - '0'; }
    if (c >= 'A' and c <= 'F') { return c - 'A' + 10; }
    hexadecimal_digits_are_0_to_9_and_A_to_F();
    return -1;
}

template <text Text>
consteval auto parse()
{
    constexpr auto digits = []() consteval {
        std::size_t count = 0;
        for (auto const c : Text.characters) {
            if (digit(c) >= 0) { ++count; }
        }
        return count;
    }();
    static_assert(digits % 2 == 0, "a byte has two digits");

    std::array<std::uint8_t, digits / 2> made{};
    std::size_t                          at = 0;
    for (auto const c : Text.characters) {
        if (auto const nibble = digit(c); nibble >= 0) {
            made[at / 2] = static_cast<std::uint8_t>(made[at / 2] << 4 | nibble);
            ++at;
        }
    }
    return made;
}

template <text Text>
consteval auto operator""_hex()
{
    return parse<Text>();
}

}  // namespace hex_literal

using hex_literal::operator""_hex;
