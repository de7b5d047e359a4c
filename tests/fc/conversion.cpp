#include <drivecodec/fc/conversion.hpp>

#include "support/verify.hpp"

#include <cstdlib>
#include <limits>

namespace {

using drivecodec::decimal;
using drivecodec::errc;
using drivecodec::error;
using drivecodec::fc::conversion;
using drivecodec::fc::conversion_factor;
using drivecodec::fc::conversion_table;

constexpr auto min = std::numeric_limits<std::int32_t>::min();
constexpr auto max = std::numeric_limits<std::int32_t>::max();

/// A factor as it is printed: `number` x 10^`exponent`, or one over that.
struct printed {
    int          index;
    std::int64_t over;
    std::int64_t under;
};

// VLT 6000 manual, "Conversion table".
constexpr printed manual[]{{2, 100, 1},  {1, 10, 1},    {0, 1, 1},      {-1, 1, 10},
                           {-2, 1, 100}, {-3, 1, 1000}, {-4, 1, 10'000}};

// FC 101 and FC 300 guides: what they have besides.
constexpr printed newer[]{
    {-5, 1, 100'000},  {-6, 1, 1'000'000}, {-7, 1, 10'000'000}, {3, 1000, 1},       {4, 10'000, 1},  {5, 100'000, 1},
    {6, 1'000'000, 1}, {67, 1, 60},        {70, 60, 1},         {75, 3'600'000, 1}, {77, 86'400, 1}, {100, 1, 1},
};

/// Does the factor make `transferred` what the printed one does?
[[nodiscard]] bool agrees(conversion_factor factor, printed wanted, std::int32_t transferred)
{
    auto const made = factor.physical(transferred);
    if (not made) { return false; }
    std::int64_t power = 1;
    for (int i = 0; i < std::abs(int{made->exponent}); ++i) { power *= 10; }
    auto const over  = made->exponent > 0 ? made->number * power : std::int64_t{made->number};
    auto const under = made->exponent > 0 ? 1 : power;
    return over * wanted.under == transferred * wanted.over * under and factor.transferred(*made)
           and *factor.transferred(*made) == transferred;
}

TEST(conversion, has_the_factors_of_the_manual)
{
    for (auto const& row : manual) {
        auto const factor = conversion(row.index);
        ASSERT_TRUE(factor) << row.index;
        EXPECT_EQ(factor->index, row.index);
        EXPECT_FALSE(factor->is_disputed);
        for (auto const number : {0, 1, -1, 7, 100, 1000, 32767, -32768}) {
            EXPECT_TRUE(agrees(*factor, row, number)) << row.index << ": " << number;
        }
    }
}

TEST(conversion, has_the_factors_of_newer_guides)
{
    for (auto const& row : newer) {
        auto const factor = conversion(row.index);
        ASSERT_TRUE(factor) << row.index;
        EXPECT_FALSE(factor->is_disputed);
        for (auto const number : {0, 60, -120, 300}) {
            EXPECT_TRUE(agrees(*factor, row, number)) << row.index << ": " << number;
        }
    }
}

TEST(conversion, has_no_other_index)
{
    auto const is_printed = [](int index) {
        if (index == 74) { return true; }
        for (auto const& row : manual) {
            if (row.index == index) { return true; }
        }
        for (auto const& row : newer) {
            if (row.index == index) { return true; }
        }
        return false;
    };
    std::size_t count = 0;
    for (int index = -1000; index <= 1000; ++index) {
        auto const factor = conversion(index);
        ASSERT_EQ(factor.has_value(), is_printed(index)) << index;
        if (factor) { ++count; }
        if (not factor) { ASSERT_EQ(factor.error(), error(errc::bad_value, 0)); }
    }
    EXPECT_EQ(count, conversion_table.size());
}

// "Conversion factor 0.1 means that the transferred value will be multiplied by 0.1": 100 is 10.0 Hz.
TEST(conversion, makes_100_of_10_hz_as_in_the_example_of_201)
{
    VERIFY(*conversion(-1)->physical(100) == decimal{10, 0});
    VERIFY(*conversion(-1)->transferred(decimal{10, 0}) == 100);
    VERIFY(*conversion(-1)->transferred(decimal{100, -1}) == 100);
    VERIFY(*conversion(-1)->transferred(decimal{1000, -1}) == 1000);  // 100 Hz, as in the example of 202
}

// The manual prints 3.6 for it, other editions 0.1 and 3600: hours to seconds.
TEST(conversion, of_index_74_is_3_6_and_disputed)
{
    VERIFY(conversion(74)->is_disputed);
    VERIFY(*conversion(74)->physical(1) == decimal{36, -1});
    VERIFY(*conversion(74)->physical(10) == decimal{36, 0});
    VERIFY(*conversion(74)->transferred(decimal{36, -1}) == 1);
    VERIFY(*conversion(74)->transferred(decimal{72, -1}) == 2);
    VERIFY(conversion(74)->transferred(decimal{1, 0}).error() == error{errc::inexact, 0});
    int disputed = 0;
    for (auto const& row : conversion_table) { disputed += row.is_disputed ? 1 : 0; }
    EXPECT_EQ(disputed, 1);

    // A factor of one's own, for a drive whose guide says 3600.
    static constexpr conversion_factor mine{.index = 74, .exponent = 0, .number = 3600};
    VERIFY(*mine.physical(2) == decimal{7200, 0} and mine != *conversion(74));
}

TEST(conversion, is_exact_or_refused)
{
    VERIFY(*conversion(67)->physical(120) == decimal{2, 0});
    VERIFY(*conversion(67)->physical(30) == decimal{5, -1});
    VERIFY(*conversion(67)->physical(-3) == decimal{-5, -2});
    VERIFY(*conversion(67)->transferred(decimal{5, -1}) == 30);
    VERIFY(*conversion(67)->transferred(decimal{-5, -2}) == -3);
    VERIFY(conversion(67)->transferred(decimal{1, -2}).error() == error{errc::inexact, 0});
    for (std::int32_t number = -600; number <= 600; ++number) {  // n / 60 has an end if 3 divides n
        auto const made = conversion(67)->physical(number);
        EXPECT_EQ(made.has_value(), number % 3 == 0) << number;
        if (made) { EXPECT_EQ(*conversion(67)->transferred(*made), number); }
    }
    VERIFY(conversion(67)->physical(1).error() == error{errc::inexact, 0});
    VERIFY(*conversion(67)->transferred(decimal{2, 0}) == 120);
    VERIFY(conversion(-1)->transferred(decimal{1005, -2}).error() == error{errc::inexact, 0});
    VERIFY(*conversion(-1)->transferred(decimal{1050, -2}) == 105);
    VERIFY(conversion(2)->transferred(decimal{150, 0}).error() == error{errc::inexact, 0});
    VERIFY(conversion(70)->transferred(decimal{90, 0}).error() == error{errc::inexact, 0});
}

TEST(conversion, does_not_overflow)
{
    VERIFY(conversion(0)->physical(max)->number == max and conversion(0)->physical(min)->number == min);
    VERIFY(*conversion(2)->physical(max) == decimal{max, 2});
    VERIFY(conversion(75)->physical(596)->number == 2'145'600'000);
    // 597 x 3,600,000 is more than 32 bits, but ends with zeros.
    VERIFY(*conversion(75)->physical(597) == decimal{21'492, 5});
    VERIFY(*conversion(75)->physical(-597) == decimal{-21'492, 5});
    VERIFY(conversion(75)->physical(max).error() == error{errc::out_of_range, 0});
    VERIFY(conversion(75)->physical(min).error() == error{errc::out_of_range, 0});
    VERIFY(conversion(-7)->transferred(decimal{215, 0}).error() == error{errc::out_of_range, 0});
    VERIFY(*conversion(-7)->transferred(decimal{214, 0}) == 2'140'000'000);
    VERIFY(conversion(67)->transferred(decimal{35'791'395, 0}).error() == error{errc::out_of_range, 0});
    VERIFY(*conversion(67)->transferred(decimal{35'791'394, 0}) == 2'147'483'640);
    VERIFY(*conversion(67)->transferred(decimal{-35'791'394, 0}) == -2'147'483'640);
    VERIFY(conversion(67)->transferred(decimal{-35'791'395, 0}).error() == error{errc::out_of_range, 0});
}

TEST(conversion, does_not_wrap_an_exponent)
{
    static constexpr conversion_factor smallest{.index = 0, .exponent = -128, .divisor = 8};
    VERIFY(*smallest.physical(8) == decimal{1, -128});
    VERIFY(smallest.physical(1).error() == error{errc::out_of_range, 0});  // 125 x 10^-131
    static constexpr conversion_factor largest{.index = 0, .exponent = 127, .number = 1'000'000'000};
    VERIFY(*largest.physical(2) == decimal{2'000'000'000, 127});
    VERIFY(largest.physical(3).error() == error{errc::out_of_range, 0});  // 300'000'000 x 10^128
}

TEST(conversion, survives_with_every_index_and_many_numbers)
{
    for (auto const& factor : conversion_table) {
        for (std::int32_t number = -120'000; number <= 120'000; number += 60) {
            auto const made = factor.physical(number);
            if (not made) {
                ASSERT_EQ(made.error(), error(errc::out_of_range, 0)) << int{factor.index};
                continue;
            }
            auto const again = factor.transferred(*made);
            ASSERT_TRUE(again) << int{factor.index} << ' ' << number;
            ASSERT_EQ(*again, number) << int{factor.index};
        }
    }
}

}  // namespace
