// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec {

/// `numerator` / `denominator` as the nearest integer; what lies in the middle goes away from zero.
/// Preconditions: denominator > 0, and twice the numerator and the denominator together fit into 63 bits.
[[nodiscard]] constexpr std::int64_t divide_to_nearest(std::int64_t numerator, std::int64_t denominator) noexcept
{
    auto const twice = 2 * numerator;
    return (twice < 0 ? twice - denominator : twice + denominator) / (2 * denominator);
}

/// 10^`exponent`. Precondition: 0 <= exponent <= 18.
[[nodiscard]] constexpr std::int64_t power_of_ten(int exponent) noexcept
{
    std::int64_t power = 1;
    for (; exponent > 0; --exponent) { power *= 10; }
    return power;
}

}  // namespace drivecodec
