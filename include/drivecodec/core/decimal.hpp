// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

#include <compare>
#include <limits>
#include <span>

namespace drivecodec {

/// `number` x 10^`exponent`, exactly: 50.0 is {500, -1}. Equal values may be written in several ways, and are equal.
struct decimal {
    std::int32_t number{};
    std::int8_t  exponent{};

    /// The integer that times 10^`wanted` is this value. Errors, at 0: `inexact` if it has more digits than that shows,
    /// `out_of_range` if the integer is larger than 32 bits.
    [[nodiscard]] constexpr result<std::int32_t> scaled_to(int wanted) const noexcept
    {
        auto scaled = number;
        if (scaled == 0) { return scaled; }
        auto shift = exponent - wanted;
        for (; shift < 0; ++shift) {
            if (scaled % 10 != 0) { return error{errc::inexact, 0}; }
            scaled /= 10;
        }
        for (; shift > 0; --shift) {
            constexpr auto most = std::numeric_limits<std::int32_t>::max() / 10;
            if (scaled > most or scaled < -most) { return error{errc::out_of_range, 0}; }
            scaled *= 10;
        }
        return scaled;
    }

    /// Precondition: number is not the least of its type, which has no opposite.
    [[nodiscard]] constexpr decimal operator-() const noexcept { return {-number, exponent}; }

    friend constexpr std::strong_ordering operator<=>(decimal a, decimal b) noexcept
    {
        auto const swapped = a.exponent < b.exponent;
        auto const coarse  = swapped ? b : a;
        auto const fine    = swapped ? a : b;
        // The coarser one in digits of the finer, as far as it takes to tell which is larger.
        constexpr std::int64_t beyond = std::int64_t{10} * std::numeric_limits<std::uint32_t>::max();
        std::int64_t           scaled = coarse.number;
        for (int shift = coarse.exponent - fine.exponent; shift > 0 and scaled < beyond and scaled > -beyond; --shift) {
            scaled *= 10;
            if (scaled == 0) { break; }
        }
        auto const order = scaled <=> std::int64_t{fine.number};
        return swapped ? 0 <=> order : order;
    }
    friend constexpr bool operator==(decimal a, decimal b) noexcept { return (a <=> b) == 0; }
};

/// A decimal number as text: a sign or none, digits, of which ' may separate groups, and at most one point.
///
/// Trailing zeros count as digits: "50.0" is {500, -1}. Errors: `bad_value` at what is none of these; `truncated` at the
/// end if there is no digit; `out_of_range` at the digit that is one too many for 32 bits.
[[nodiscard]] constexpr result<decimal> parse_decimal(std::span<char const> text) noexcept
{
    auto const  is_negative = not text.empty() and text.front() == '-';
    std::size_t at          = is_negative or (not text.empty() and text.front() == '+') ? 1 : 0;
    decimal     read;
    auto        has_digit = false;
    auto        has_point = false;
    for (; at < text.size(); ++at) {
        auto const character = text[at];
        if (character == '.' and not has_point) {
            has_point = true;
        } else if (character >= '0' and character <= '9') {
            auto const digit = character - '0';
            if (read.number > (std::numeric_limits<std::int32_t>::max() - digit) / 10
                or read.exponent == std::numeric_limits<std::int8_t>::min()) {
                return error{errc::out_of_range, at};
            }
            read.number   = read.number * 10 + digit;
            read.exponent = static_cast<std::int8_t>(read.exponent - (has_point ? 1 : 0));
            has_digit     = true;
        } else if (character != '\'' or not has_digit) {
            return error{errc::bad_value, at};
        }
    }
    if (not has_digit) { return error{errc::truncated, at + 1}; }
    return is_negative ? -read : read;
}

}  // namespace drivecodec
