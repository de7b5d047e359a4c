// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/decimal.hpp>
#include <drivecodec/core/table.hpp>

#include <array>

namespace drivecodec::fc {

/// What a transferred number is to be multiplied with: `number` x 10^`exponent` / `divisor`. VLT 6000 manual,
/// "Conversion table". Preconditions of its functions: number and divisor are positive.
struct conversion_factor {
    std::int8_t  index;
    std::int8_t  exponent;
    std::int32_t number      = 1;
    std::int32_t divisor     = 1;
    bool         is_disputed = false;  ///< Editions of the same maker's guides print other factors for this index.

    /// The value that was transferred as `transferred`. Errors, at 0: `inexact` for one without an end, as 1/60;
    /// `out_of_range` where `decimal` does not hold it.
    [[nodiscard]] constexpr result<decimal> physical(std::int32_t transferred) const noexcept
    {
        auto product = std::int64_t{transferred} * number;
        int  digits  = 0;  // behind the point, besides those of the exponent
        for (; product % divisor != 0; ++digits) {
            if (digits == most_digits or product > limits::max() / 10 or product < limits::min() / 10) {
                return error{errc::inexact, 0};
            }
            product *= 10;
        }
        auto quotient = product / divisor;
        for (; not is_32_bits(quotient) and quotient % 10 == 0; --digits) { quotient /= 10; }
        auto const power = exponent - digits;
        if (not is_32_bits(quotient) or power < std::numeric_limits<std::int8_t>::min()
            or power > std::numeric_limits<std::int8_t>::max()) {
            return error{errc::out_of_range, 0};
        }
        return decimal{static_cast<std::int32_t>(quotient), static_cast<std::int8_t>(power)};
    }

    /// The number to transfer. Errors, at 0: `inexact` where none stands for the value, `out_of_range` where 32 bits do
    /// not hold it.
    [[nodiscard]] constexpr result<std::int32_t> transferred(decimal value) const noexcept
    {
        auto product = std::int64_t{value.number} * divisor;
        if (product == 0) { return 0; }
        for (int at = value.exponent; at > exponent; --at) {
            if (product > limits::max() / 10 or product < limits::min() / 10) { return error{errc::out_of_range, 0}; }
            product *= 10;
        }
        for (int at = value.exponent; at < exponent; ++at) {
            if (product % 10 != 0) { return error{errc::inexact, 0}; }
            product /= 10;
        }
        if (product % number != 0) { return error{errc::inexact, 0}; }
        if (not is_32_bits(product / number)) { return error{errc::out_of_range, 0}; }
        return static_cast<std::int32_t>(product / number);
    }

    friend constexpr bool operator==(conversion_factor, conversion_factor) noexcept = default;

private:
    using limits = std::numeric_limits<std::int64_t>;

    static constexpr int most_digits = 9;  // a number of 32 bits has no more

    [[nodiscard]] static constexpr bool is_32_bits(std::int64_t given) noexcept
    {
        return given >= std::numeric_limits<std::int32_t>::min() and given <= std::numeric_limits<std::int32_t>::max();
    }
};

/// All indexes: from -4 to 2 and 74 the VLT 6000 has, the others are of newer FC guides. 67 to 77 are for times.
///
/// 74 is 3.6 in this manual; other editions print 0.1, and 3600, with which hours become seconds. Nobody can know: ask
/// the drive's own manual, and use a factor of one's own.
inline constexpr std::array<conversion_factor, 20> conversion_table{{
    {.index = -7, .exponent = -7},
    {.index = -6, .exponent = -6},
    {.index = -5, .exponent = -5},
    {.index = -4, .exponent = -4},
    {.index = -3, .exponent = -3},
    {.index = -2, .exponent = -2},
    {.index = -1, .exponent = -1},
    {.index = 0, .exponent = 0},
    {.index = 1, .exponent = 1},
    {.index = 2, .exponent = 2},
    {.index = 3, .exponent = 3},
    {.index = 4, .exponent = 4},
    {.index = 5, .exponent = 5},
    {.index = 6, .exponent = 6},
    {.index = 67, .exponent = 0, .divisor = 60},
    {.index = 70, .exponent = 0, .number = 60},
    {.index = 74, .exponent = -1, .number = 36, .is_disputed = true},
    {.index = 75, .exponent = 0, .number = 3'600'000},
    {.index = 77, .exponent = 0, .number = 86'400},
    {.index = 100, .exponent = 0},
}};
static_assert(strictly_ascending(conversion_table, &conversion_factor::index));

/// Errors: `bad_value` at 0 for an index that no guide has.
[[nodiscard]] constexpr result<conversion_factor> conversion(int index) noexcept
{
    auto const  narrow = static_cast<std::int8_t>(index);
    auto const* row    = find_row(conversion_table, &conversion_factor::index, narrow);
    if (row == nullptr or narrow != index) { return error{errc::bad_value, 0}; }
    return *row;
}

}  // namespace drivecodec::fc
