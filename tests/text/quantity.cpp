#include <drivecodec/text/quantity.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace {

using drivecodec::decimal;
using drivecodec::describe;
using drivecodec::parse_decimal;
using drivecodec::quantity;
using drivecodec::unit;
using namespace drivecodec::literals;

constexpr auto min = std::numeric_limits<std::int32_t>::min();
constexpr auto max = std::numeric_limits<std::int32_t>::max();

constexpr bool reads(auto const& thing, std::string_view expected)
{
    std::array<char, 200> buffer{};
    return describe(thing, buffer) == expected;
}

std::string text_of(decimal value)
{
    std::array<char, 200> buffer{};
    return std::string{describe(value, buffer)};
}

TEST(text_decimal, has_the_digits_of_its_exponent)
{
    VERIFY(reads(decimal{500, -1}, "50.0"));
    VERIFY(reads(decimal{50, 0}, "50"));
    VERIFY(reads(decimal{4, 3}, "4000"));
    VERIFY(reads(decimal{412, -1}, "41.2"));
    VERIFY(reads(decimal{412, -2}, "4.12"));
    VERIFY(reads(decimal{412, -3}, "0.412"));
    VERIFY(reads(decimal{412, -5}, "0.00412"));
    VERIFY(reads(decimal{1, -10}, "0.0000000001"));
}

TEST(text_decimal, may_be_negative)
{
    VERIFY(reads(decimal{-5, -2}, "-0.05"));
    VERIFY(reads(decimal{-500, -1}, "-50.0"));
    VERIFY(reads(decimal{-4, 3}, "-4000"));
    VERIFY(reads(decimal{-1500, 0}, "-1500"));
}

TEST(text_decimal, of_nothing_is_0)
{
    VERIFY(reads(decimal{}, "0"));
    VERIFY(reads(decimal{0, -1}, "0.0"));
    VERIFY(reads(decimal{0, -3}, "0.000"));
    VERIFY(reads(decimal{0, 3}, "0"));
}

TEST(text_decimal, may_be_as_large_and_small_as_there_is)
{
    VERIFY(reads(decimal{min, 0}, "-2147483648"));
    VERIFY(reads(decimal{max, 0}, "2147483647"));
    VERIFY(reads(decimal{min, -9}, "-2.147483648"));
    VERIFY(reads(decimal{min, -10}, "-0.2147483648"));
    EXPECT_EQ(text_of({1, 127}), "1" + std::string(127, '0'));
    EXPECT_EQ(text_of({min, 127}), "-2147483648" + std::string(127, '0'));
    EXPECT_EQ(text_of({max, -128}), "0." + std::string(118, '0') + "2147483647");
    EXPECT_EQ(text_of({-1, -128}), "-0." + std::string(127, '0') + "1");
}

/// The other way, with strings alone: all digits and zeros enough, then a point.
std::string expected_text(std::int32_t number, int exponent)
{
    auto digits = std::to_string(number < 0 ? -static_cast<std::int64_t>(number) : number);
    if (exponent > 0 and number != 0) { digits += std::string(static_cast<std::size_t>(exponent), '0'); }
    if (exponent < 0) {
        auto const fraction = static_cast<std::size_t>(-exponent);
        if (digits.size() <= fraction) { digits = std::string(fraction + 1 - digits.size(), '0') + digits; }
        digits.insert(digits.size() - fraction, ".");
    }
    return (number < 0 ? "-" : "") + digits;
}

TEST(text_decimal, is_read_back_digit_for_digit)
{
    std::mt19937 random{1};
    for (int i = 0; i < 100'000; ++i) {
        auto const number   = static_cast<std::int32_t>(random()) >> random() % 32;
        auto const exponent = static_cast<std::int8_t>(random());
        auto const text     = text_of({number, exponent});
        ASSERT_EQ(text, expected_text(number, exponent));
        if (exponent <= 0) {
            auto const read = parse_decimal(text);
            ASSERT_TRUE(read) << text;
            ASSERT_EQ(read->number, number) << text;
            ASSERT_EQ(read->exponent, exponent) << text;
        } else if (auto const read = parse_decimal(text)) {
            ASSERT_EQ(*read, (decimal{number, exponent})) << text;
        }
    }
}

TEST(text_unit, is_its_symbol)
{
    VERIFY(to_string(unit::none).empty());
    VERIFY(to_string(unit::hertz) == "Hz");
    VERIFY(to_string(unit::second) == "s");
    VERIFY(to_string(unit::minute) == "min");
    VERIFY(to_string(unit::hour) == "h");
    VERIFY(to_string(unit::revolution_per_minute) == "rpm");
    VERIFY(to_string(unit::ampere) == "A");
    VERIFY(to_string(unit::volt) == "V");
    VERIFY(to_string(unit::watt) == "W");
    VERIFY(to_string(unit::horsepower) == "hp");
    VERIFY(to_string(unit::watt_hour) == "Wh");
    VERIFY(to_string(unit::percent) == "%");
    VERIFY(to_string(unit::degree_celsius) == "degC");
    VERIFY(to_string(unit::ohm) == "ohm");
    VERIFY(to_string(unit::henry) == "H");
    VERIFY(to_string(unit::newton_metre) == "Nm");
}

TEST(text_unit, has_a_symbol_of_its_own_but_for_none)
{
    EXPECT_EQ(names_of_all_values<unit>().size(), static_cast<std::size_t>(unit::newton_metre));
    VERIFY(not takes_prefix(static_cast<unit>(255)));
}

constexpr auto high_speed  = 50.0_Hz;
constexpr auto backwards   = -1500_rpm;
constexpr auto filter_time = 250_ms;
constexpr auto torque      = 100_percent;
constexpr auto switching   = 4_kHz;
constexpr auto energy      = 5_MWh;
constexpr auto power       = 0.75_kW;
constexpr auto rated       = 1.5_hp;
constexpr auto heat_sink   = -5_degC;

TEST(text_quantity, is_number_and_symbol)
{
    VERIFY(reads(high_speed, "50.0 Hz"));
    VERIFY(reads(backwards, "-1500 rpm"));
    VERIFY(reads(filter_time, "0.250 s"));
    VERIFY(reads(torque, "100 %"));
    VERIFY(reads(rated, "1.5 hp"));
    VERIFY(reads(heat_sink, "-5 degC"));
    VERIFY(reads(quantity<unit::none>{15, -1}, "1.5"));
}

TEST(text_quantity, in_large_steps_is_written_in_thousands)
{
    VERIFY(reads(switching, "4 kHz"));
    VERIFY(reads(quantity<unit::hertz>{40, 2}, "4.0 kHz"));
    VERIFY(reads(quantity<unit::hertz>{400, 1}, "4.00 kHz"));
    VERIFY(reads(quantity<unit::hertz>{4000, 0}, "4000 Hz"));
    VERIFY(reads(quantity<unit::hertz>{-4, 1}, "-0.04 kHz"));
    VERIFY(reads(quantity<unit::hertz>{0, 2}, "0.0 kHz"));
    VERIFY(reads(quantity<unit::watt>{1, 4}, "10 kW"));
    VERIFY(reads(power, "0.75 kW"));
    VERIFY(reads(energy, "5000 kWh"));
}

TEST(text_quantity, without_a_prefix_is_written_in_full)
{
    VERIFY(reads(quantity<unit::second>{4, 3}, "4000 s"));
    VERIFY(reads(quantity<unit::revolution_per_minute>{15, 2}, "1500 rpm"));
    VERIFY(reads(quantity<unit::none>{15, 2}, "1500"));
}

}  // namespace
