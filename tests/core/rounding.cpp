#include <drivecodec/core/rounding.hpp>

#include "support/verify.hpp"

#include <cmath>

namespace {

using drivecodec::divide_to_nearest;
using drivecodec::power_of_ten;

TEST(divide_to_nearest, takes_the_nearest)
{
    VERIFY(divide_to_nearest(0, 3) == 0);
    VERIFY(divide_to_nearest(4, 3) == 1);
    VERIFY(divide_to_nearest(5, 3) == 2);
    VERIFY(divide_to_nearest(-4, 3) == -1);
    VERIFY(divide_to_nearest(-5, 3) == -2);
    VERIFY(divide_to_nearest(7, 1) == 7);
}

TEST(divide_to_nearest, goes_away_from_zero_in_the_middle)
{
    VERIFY(divide_to_nearest(1, 2) == 1);
    VERIFY(divide_to_nearest(3, 2) == 2);
    VERIFY(divide_to_nearest(5, 2) == 3);
    VERIFY(divide_to_nearest(-1, 2) == -1);
    VERIFY(divide_to_nearest(-3, 2) == -2);
    VERIFY(divide_to_nearest(-5, 2) == -3);
}

// The standard library's rounding does the same in floating point, which is exact enough for these.
TEST(divide_to_nearest, is_std_round_for_small_numbers)
{
    for (std::int64_t denominator = 1; denominator <= 64; ++denominator) {
        for (std::int64_t numerator = -1000; numerator <= 1000; ++numerator) {
            auto const wanted =
                std::llround(static_cast<long double>(numerator) / static_cast<long double>(denominator));
            ASSERT_EQ(divide_to_nearest(numerator, denominator), wanted) << numerator << " / " << denominator;
        }
    }
}

// Twice the numerator and the denominator are 2^63 - 1 together.
TEST(divide_to_nearest, does_not_overflow_up_to_its_precondition)
{
    VERIFY(divide_to_nearest(0x3FFF'FFFF'FFFF'FFFF, 1) == 0x3FFF'FFFF'FFFF'FFFF);
    VERIFY(divide_to_nearest(-0x3FFF'FFFF'FFFF'FFFF, 1) == -0x3FFF'FFFF'FFFF'FFFF);
    VERIFY(divide_to_nearest(499'999'999'999'999'999, 1'000'000'000'000'000'000) == 0);
    VERIFY(divide_to_nearest(500'000'000'000'000'000, 1'000'000'000'000'000'000) == 1);
    VERIFY(divide_to_nearest(-500'000'000'000'000'000, 1'000'000'000'000'000'000) == -1);
}

TEST(power_of_ten, is_known_up_to_18)
{
    VERIFY(power_of_ten(0) == 1);
    VERIFY(power_of_ten(1) == 10);
    VERIFY(power_of_ten(9) == 1'000'000'000);
    VERIFY(power_of_ten(18) == 1'000'000'000'000'000'000);
}

}  // namespace
