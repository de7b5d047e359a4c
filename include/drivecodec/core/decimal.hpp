// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

#include <compare>
#include <limits>
#include <span>

namespace drivecodec {

/// `number` x 10^`exponent`: 50.0 is {500, -1}. Exact, as drives' registers are: 41.2 has no binary fraction.
///
/// The same value may be written with more digits or fewer: 50.0 == 50, but the digits are kept.
struct decimal {
    std::int32_t number   = 0;
    std::int8_t  exponent = 0;

    /// The n with n x 10^`to` equal to it.
    ///
    /// Errors: `inexact` where digits would be lost, `out_of_range` where n does not fit into 32 bits.
    [[nodiscard]] constexpr result<std::int32_t> scaled_to(int to) const noexcept
    {
        // At most ten turns, whatever the exponents: a number other than 0 then has no room or no zeros left.
        auto scaled = number;
        if (scaled == 0) { return scaled; }
        for (int at = exponent; at > to; --at) {
            if (scaled > limits::max() / 10 or scaled < limits::min() / 10) { return error{errc::out_of_range, 0}; }
            scaled *= 10;
        }
        for (int at = exponent; at < to; ++at) {
            if (scaled % 10 != 0) { return error{errc::inexact, 0}; }
            scaled /= 10;
        }
        return scaled;
    }

    /// Precondition: number > -2147483648, of which 32 bits do not hold the opposite.
    [[nodiscard]] friend constexpr decimal operator-(decimal of) noexcept { return {-of.number, of.exponent}; }

    /// By value. Weak: what is equal may have other digits.
    [[nodiscard]] friend constexpr std::weak_ordering operator<=>(decimal a, decimal b) noexcept
    {
        if (a.exponent >= b.exponent) {
            // What does not fit into 32 bits is beyond every number that does.
            auto const scaled = a.scaled_to(b.exponent);
            return scaled ? *scaled <=> b.number : a.number <=> 0;
        }
        auto const scaled = b.scaled_to(a.exponent);
        return scaled ? a.number <=> *scaled : 0 <=> b.number;
    }
    [[nodiscard]] friend constexpr bool operator==(decimal a, decimal b) noexcept
    {
        return (a <=> b) == std::weak_ordering::equivalent;
    }

private:
    using limits = std::numeric_limits<std::int32_t>;
};

namespace detail {

[[nodiscard]] constexpr bool is_digit(char character) noexcept
{
    return character >= '0' and character <= '9';
}

}  // namespace detail

/// A number as C++ writes one, but always decimal: an optional sign, digits with at most one point, and ' between
/// digits. "50.0" is {500, -1}, "-.5" is {-5, -1}, "1'000" is {1000, 0}, "010" is {10, 0}. No blanks, no terminating
/// zero, no 1e3.
///
/// Errors: `bad_value` at the first character that cannot be there; `truncated` where a digit has to follow;
/// `out_of_range` at the first digit that fits no more: `number` has 32 bits, fractions have at most 128 digits.
/// Precondition: text.size() < 65535.
[[nodiscard]] constexpr result<decimal> parse_decimal(std::span<char const> text) noexcept
{
    constexpr std::uint32_t max = std::numeric_limits<std::int32_t>::max();

    bool const    negative  = not text.empty() and text.front() == '-';
    bool const    is_signed = negative or (not text.empty() and text.front() == '+');
    std::uint32_t magnitude = 0;
    int           exponent  = 0;
    bool          has_point = false;
    bool          has_digit = false;
    char          before    = '\0';
    for (std::size_t i = is_signed ? 1 : 0; i < text.size(); ++i) {
        auto const c = text.data()[i];
        if (detail::is_digit(c)) {
            auto const digit = static_cast<std::uint32_t>(c - '0');
            if (magnitude > max / 10 or magnitude * 10 + digit > max + (negative ? 1U : 0U)) {
                return error{errc::out_of_range, i};
            }
            if (has_point and --exponent < std::numeric_limits<std::int8_t>::min()) {
                return error{errc::out_of_range, i};
            }
            magnitude = magnitude * 10 + digit;
            has_digit = true;
        } else if (c == '.' and not has_point and before != '\'') {
            has_point = true;
        } else if (c != '\'' or not detail::is_digit(before)) {
            return error{errc::bad_value, i};
        }
        before = c;
    }
    if (not has_digit or before == '\'') { return error{errc::truncated, text.size() + 1}; }
    return decimal{static_cast<std::int32_t>(negative ? 0 - magnitude : magnitude), static_cast<std::int8_t>(exponent)};
}

}  // namespace drivecodec
