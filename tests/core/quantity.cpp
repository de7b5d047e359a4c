#include <drivecodec/core/quantity.hpp>

#include "support/verify.hpp"

#include <array>
#include <concepts>
#include <string_view>
#include <type_traits>

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;

/// Exactly these digits: equality alone would take 50 for 50.0.
template <unit Unit>
[[nodiscard]] constexpr bool is(quantity<Unit> q, unit wanted, std::int32_t number, int exponent) noexcept
{
    return Unit == wanted and q.number == number and q.exponent == exponent;
}

TEST(quantity, has_a_literal_for_every_unit)
{
    VERIFY(is(50_Hz, unit::hertz, 50, 0));
    VERIFY(is(4_kHz, unit::hertz, 4, 3));
    VERIFY(is(2_s, unit::second, 2, 0));
    VERIFY(is(250_ms, unit::second, 250, -3));
    VERIFY(is(5_min, unit::minute, 5, 0));
    VERIFY(is(8_h, unit::hour, 8, 0));
    VERIFY(is(1500_rpm, unit::revolution_per_minute, 1500, 0));
    VERIFY(is(16_A, unit::ampere, 16, 0));
    VERIFY(is(20_mA, unit::ampere, 20, -3));
    VERIFY(is(400_V, unit::volt, 400, 0));
    VERIFY(is(10_mV, unit::volt, 10, -3));
    VERIFY(is(3_kV, unit::volt, 3, 3));
    VERIFY(is(750_W, unit::watt, 750, 0));
    VERIFY(is(11_kW, unit::watt, 11, 3));
    VERIFY(is(15_hp, unit::horsepower, 15, 0));
    VERIFY(is(9_Wh, unit::watt_hour, 9, 0));
    VERIFY(is(7_kWh, unit::watt_hour, 7, 3));
    VERIFY(is(6_MWh, unit::watt_hour, 6, 6));
    VERIFY(is(100_percent, unit::percent, 100, 0));
    VERIFY(is(40_degC, unit::degree_celsius, 40, 0));
    VERIFY(is(12_ohm, unit::ohm, 12, 0));
    VERIFY(is(13_mohm, unit::ohm, 13, -3));
    VERIFY(is(14_H, unit::henry, 14, 0));
    VERIFY(is(17_mH, unit::henry, 17, -3));
    VERIFY(is(18_Nm, unit::newton_metre, 18, 0));
}

TEST(quantity, keeps_the_digits_of_its_literal)
{
    VERIFY(is(50.0_Hz, unit::hertz, 500, -1));
    VERIFY(is(50.00_Hz, unit::hertz, 5000, -2));
    VERIFY(is(41.2_Hz, unit::hertz, 412, -1));
    VERIFY(is(.5_s, unit::second, 5, -1));
    VERIFY(is(5._s, unit::second, 5, 0));
    VERIFY(is(0_A, unit::ampere, 0, 0));
    VERIFY(is(0.0_A, unit::ampere, 0, -1));
    VERIFY(is(1'500_rpm, unit::revolution_per_minute, 1500, 0));
    VERIFY(is(2'147'483'647_Hz, unit::hertz, 2'147'483'647, 0));
}

TEST(quantity, of_a_prefix_has_it_in_its_exponent)
{
    VERIFY(is(2.5_kHz, unit::hertz, 25, 2));
    VERIFY(is(0.75_kW, unit::watt, 75, 1));
    VERIFY(is(4.0_mA, unit::ampere, 40, -4));
    VERIFY(is(0.1234_kWh, unit::watt_hour, 1234, -1));
    VERIFY(4_kHz == 4000_Hz);
    VERIFY(250_ms == 0.25_s);
    VERIFY(1500_mA == 1.5_A);
    VERIFY(0.75_kW == 750_W);
}

// 2^24 + 1 has no float, and 0.1 + 0.2 is not 0.3 as double: a way through floating point would show.
TEST(quantity, is_exact)
{
    VERIFY(*(16'777.217_Hz).scaled_to(-3) == 16'777'217);
    VERIFY(*(214'748.3647_Hz).scaled_to(-4) == 2'147'483'647);
    VERIFY(*(0.3_Hz).scaled_to(-1) == 3);
    VERIFY(*(41.2_Hz).scaled_to(-2) == 4120);
    VERIFY((41.25_Hz).scaled_to(-1).error() == error{errc::inexact, 0});
    VERIFY((4_kHz).scaled_to(-7).error() == error{errc::out_of_range, 0});
}

TEST(quantity, has_an_opposite_of_the_same_unit)
{
    VERIFY(is(-41.2_Hz, unit::hertz, -412, -1));
    VERIFY(is(-4_kHz, unit::hertz, -4, 3));
    VERIFY(is(-(-5_degC), unit::degree_celsius, 5, 0));
    VERIFY(std::same_as<decltype(-50_Hz), quantity<unit::hertz>>);
    VERIFY(-2'147'483'647_Hz < 0_Hz);
}

TEST(quantity, is_ordered_by_value)
{
    VERIFY(50_Hz == 50.0_Hz);
    VERIFY(50_Hz != 50.1_Hz);
    VERIFY(49.99_Hz < 50_Hz);
    VERIFY(-50_Hz < 50_Hz);
    VERIFY(-50_Hz < -49.9_Hz);
    VERIFY(4_kHz > 3999.9_Hz);
    VERIFY(20_mA < 1_A);
    VERIFY(50_Hz <= 50.0_Hz and 50_Hz >= 50.0_Hz);
    VERIFY(quantity<unit::hertz>{} == 0_Hz);
}

template <typename A, typename B>
concept comparable = requires(A a, B b) { a == b; } or requires(A a, B b) { a < b; };

TEST(quantity, has_nothing_to_do_with_another_unit)
{
    using hertz  = quantity<unit::hertz>;
    using second = quantity<unit::second>;
    VERIFY(comparable<hertz, hertz>);
    VERIFY(not comparable<hertz, second>);
    VERIFY(not comparable<hertz, int>);
    VERIFY(not std::is_convertible_v<hertz, second>);
    VERIFY(not std::is_assignable_v<hertz&, second>);
    VERIFY(not std::is_assignable_v<hertz&, int>);
}

TEST(quantity, has_one_type_for_all_exponents)
{
    VERIFY(std::same_as<decltype(4_kHz), decltype(41.2_Hz)>);
    VERIFY(std::same_as<decltype(250_ms), decltype(2_s)>);
}

template <quantity<unit::hertz> Limit>
struct limited {
    static constexpr auto limit = Limit;
};

TEST(quantity, is_a_template_argument)
{
    VERIFY(is(limited<41.2_Hz>::limit, unit::hertz, 412, -1));
    VERIFY(is(limited<-4_kHz>::limit, unit::hertz, -4, 3));
    VERIFY(std::same_as<limited<50_Hz>, limited<50_Hz>>);
    // Arguments are the same if their members are, so digits count.
    VERIFY(not std::same_as<limited<50_Hz>, limited<50.0_Hz>>);
}

TEST(quantity, is_made_of_any_decimal)
{
    using hertz = quantity<unit::hertz>;
    VERIFY(std::is_aggregate_v<hertz> and std::is_trivially_copyable_v<hertz> and sizeof(hertz) == sizeof(decimal));
    VERIFY(hertz::unit_of_measure == unit::hertz);
    VERIFY(is(hertz{}, unit::hertz, 0, 0));
    VERIFY(is(hertz{412, -1}, unit::hertz, 412, -1));
    VERIFY(is(hertz::of({412, -1}), unit::hertz, 412, -1));
    VERIFY((41.2_Hz).value().number == 412 and (41.2_Hz).value().exponent == -1);
    // But of no decimal by chance, nor a decimal of it.
    VERIFY(not std::is_convertible_v<decimal, hertz> and not std::is_convertible_v<hertz, decimal>);
    VERIFY(not comparable<hertz, decimal>);
}

TEST(quantity, is_read_alike_from_literals_and_from_text)
{
    constexpr std::array<std::string_view, 5> texts{"50.0", "1'500", ".5", "5.", "2147483647"};
    constexpr std::array                      literals{50.0_Hz, 1'500_Hz, .5_Hz, 5._Hz, 2147483647_Hz};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        auto const read = parse_decimal(opaque(texts[i]));
        ASSERT_TRUE(read) << texts[i];
        EXPECT_TRUE(is(quantity<unit::hertz>::of(*read), unit::hertz, literals[i].number, literals[i].exponent));
    }
}

// Where Clang 14 does not link what is consteval, or calls it at run time.
template <typename Quantity>
bool is_between(Quantity q)
{
    auto const below = [](auto other) { return other < 60.0_Hz; };
    return q > 40.0_Hz and below(q);
}

struct setting {
    quantity<unit::hertz>  high_speed = 50.0_Hz;
    quantity<unit::second> ramp       = 250_ms;
};

TEST(quantity, has_literals_that_may_stand_anywhere)
{
    EXPECT_TRUE(is_between(opaque(quantity<unit::hertz>{412, -1})));
    EXPECT_FALSE(is_between(opaque(quantity<unit::hertz>{600, -1})));
    EXPECT_TRUE(is(opaque(setting{}).high_speed, unit::hertz, 500, -1));
    EXPECT_TRUE(is(opaque(setting{}).ramp, unit::second, 250, -3));
}

}  // namespace
