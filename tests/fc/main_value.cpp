#include <drivecodec/fc/main_value.hpp>

#include "support/verify.hpp"

#include <random>

namespace {

using namespace drivecodec::literals;
using drivecodec::errc;
using drivecodec::error;
using drivecodec::quantity;
using drivecodec::unit;
using drivecodec::fc::output_frequency;
using drivecodec::fc::reference;
using percent = quantity<unit::percent>;
using hertz   = quantity<unit::hertz>;

constexpr error beyond{errc::out_of_range, 0};

constexpr std::uint16_t raw_of(reference constant)
{
    return constant.raw();
}

//=== the manual's numbers ===//

// VLT 6000 manual, "Serial communication reference" and the examples of control word and status word.
TEST(main_value, has_100_percent_at_4000h)
{
    VERIFY(raw_of(100_percent) == 0x4000);
    VERIFY(raw_of(50_percent) == 0x2000);
    VERIFY(raw_of(-50_percent) == 0xE000);
    VERIFY(raw_of(-100_percent) == 0xC000);
    VERIFY(raw_of(0_percent) == 0 and reference{}.raw() == 0);
    VERIFY(*output_frequency::from_raw(0x2000).percent() == 50_percent);
    VERIFY(*output_frequency::from_raw(0xE000).percent() == -50_percent);
    VERIFY(*reference::from_raw(0x4000).percent() == 100_percent);
}

TEST(main_value, is_25_hz_at_2000h_of_0_to_50_hz)
{
    VERIFY(*output_frequency::from_raw(0x2000).frequency(0_Hz, 50_Hz) == 25_Hz);
    VERIFY(output_frequency::make(25_Hz, 0_Hz, 50_Hz)->raw() == 0x2000);
    VERIFY(*output_frequency::from_raw(0xE000).frequency(0_Hz, 50_Hz) == -25_Hz);
    VERIFY(output_frequency::make(-25_Hz, 0_Hz, 50_Hz)->raw() == 0xE000);
}

TEST(main_value, is_a_number_in_twos_complement)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const made = reference::from_raw(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(made.raw(), raw);
        ASSERT_EQ(made.number(), raw < 0x8000 ? static_cast<int>(raw) : static_cast<int>(raw) - 0x10000);
    }
}

//=== percent ===//

// 2 x 16384 is one more than 15 bits hold: the manual's "200 %" is 199.9939 %.
TEST(main_value, ends_at_199_994_although_200_percent_is_printed)
{
    VERIFY(*reference::from_raw(0x7FFF).percent() == 199.994_percent);
    VERIFY(*reference::from_raw(0x8001).percent() == -199.994_percent);
    VERIFY(raw_of(199.994_percent) == 0x7FFF);
    VERIFY(raw_of(-199.994_percent) == 0x8001);
    // 32767.5 x 100 / 16384 = 199.99694...: up to there 32767 is the nearest.
    VERIFY(raw_of(199.9969_percent) == 0x7FFF);
    VERIFY(raw_of(-199.9969_percent) == 0x8001);
    VERIFY(reference::make(199.997_percent).error() == beyond);
    VERIFY(reference::make(-199.997_percent).error() == beyond);
    VERIFY(reference::make(200_percent).error() == beyond);
    VERIFY(reference::make(-200_percent).error() == beyond);
}

TEST(main_value, of_8000h_is_no_value)
{
    VERIFY(reference::from_raw(0x8000).percent().error() == beyond);
    VERIFY(reference::from_raw(0x8000).frequency(0_Hz, 50_Hz).error() == beyond);
    VERIFY(reference::from_raw(0x8000).raw() == 0x8000);  // but it survives
}

TEST(main_value, survives_as_percent_with_every_number)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const given = reference::from_raw(static_cast<std::uint16_t>(raw));
        for (int exponent = -7; exponent <= -3; ++exponent) {
            auto const read = given.percent(exponent);
            ASSERT_EQ(read.has_value(), raw != 0x8000) << raw;
            if (not read) { continue; }
            ASSERT_EQ(read->exponent, exponent);
            auto const again = reference::make(*read);
            ASSERT_TRUE(again) << raw;
            ASSERT_EQ(again->raw(), raw) << exponent;
        }
    }
}

/// The nearest integer, in the middle the one away from zero: written with the remainder.
[[nodiscard]] std::int64_t nearest(std::int64_t numerator, std::int64_t denominator)
{
    auto const magnitude = numerator < 0 ? -numerator : numerator;
    auto const rounded   = magnitude / denominator + (magnitude % denominator * 2 >= denominator ? 1 : 0);
    return numerator < 0 ? -rounded : rounded;
}

[[nodiscard]] std::int64_t ten_to(int exponent)
{
    std::int64_t power = 1;
    for (int i = 0; i < exponent; ++i) { power *= 10; }
    return power;
}

TEST(main_value, as_percent_is_the_nearest_step)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        if (raw == 0x8000) { continue; }
        auto const given = output_frequency::from_raw(static_cast<std::uint16_t>(raw));
        for (int exponent = -7; exponent <= 0; ++exponent) {
            auto const wanted = nearest(std::int64_t{given.number()} * 100 * ten_to(-exponent), 16384);
            auto const read   = *given.percent(exponent);
            ASSERT_EQ(read.number, static_cast<std::int32_t>(wanted)) << raw << ' ' << exponent;
            ASSERT_EQ(read.exponent, exponent);
        }
    }
}

// One step is 100 / 16384 % = 0.006103515625 %. In the middle of two lies 25 n / 2^13 % with an odd n, which takes 13
// digits behind the point: no percentage of 32 bits is there, but one may be beside it.
TEST(main_value, of_percent_beside_the_middle_goes_to_the_nearer)
{
    VERIFY(raw_of(0.003051757_percent) == 0);
    VERIFY(raw_of(0.003051758_percent) == 1);
    VERIFY(raw_of(-0.003051757_percent) == 0);
    VERIFY(raw_of(-0.003051758_percent) == 0xFFFF);
}

TEST(main_value, in_the_middle_goes_away_from_zero)
{
    VERIFY(output_frequency::from_raw(2048).percent(0)->number == 13);  // 12.5 %
    VERIFY(output_frequency::from_raw(0xF800).percent(0)->number == -13);
    VERIFY(output_frequency::from_raw(3 * 2048).percent(0)->number == 38);           // 37.5 %
    VERIFY(output_frequency::from_raw(1).frequency(0_Hz, 8192_Hz, 0)->number == 1);  // 0.5 Hz
    VERIFY(output_frequency::from_raw(0xFFFF).frequency(0_Hz, 8192_Hz, 0)->number == -1);
    VERIFY(output_frequency::from_raw(5).frequency(0_Hz, 8192_Hz, 0)->number == 3);  // 2.5 Hz
    VERIFY(reference::make(0.5_Hz, 0_Hz, 16384_Hz)->raw() == 1);
    VERIFY(reference::make(-0.5_Hz, 0_Hz, 16384_Hz)->raw() == 0xFFFF);
    VERIFY(reference::make(2.5_Hz, 0_Hz, 16384_Hz)->raw() == 3);
    VERIFY(reference::make(-2.5_Hz, 0_Hz, 16384_Hz)->raw() == 0xFFFD);
    VERIFY(reference::make(32767.4_Hz, 0_Hz, 16384_Hz)->raw() == 0x7FFF);
    VERIFY(reference::make(32767.5_Hz, 0_Hz, 16384_Hz).error() == beyond);
}

TEST(main_value, of_percent_is_the_nearest_number)
{
    std::mt19937 random{2};
    for (int round = 0; round < 200'000; ++round) {
        auto const exponent = static_cast<int>(random() % 22) - 19;  // -19 to 2
        auto const bits     = random() % 32;
        auto       number   = static_cast<std::int32_t>(random() >> bits);
        if (random() % 2 == 0) { number = number == -0x7FFFFFFF - 1 ? 0 : -number; }
        auto const made = reference::make(percent{number, static_cast<std::int8_t>(exponent)});

        auto const over   = std::int64_t{number} * 16384 * ten_to(exponent > 0 ? exponent : 0);
        auto const wanted = exponent < -16 ? 0 : nearest(over, 100 * ten_to(exponent < 0 ? -exponent : 0));
        auto const fits   = wanted >= -32767 and wanted <= 32767;
        ASSERT_EQ(made.has_value(), fits) << number << "e" << exponent;
        if (fits) {
            ASSERT_EQ(made->number(), static_cast<int>(wanted)) << number << "e" << exponent;
        } else {
            ASSERT_EQ(made.error(), beyond);
        }
    }
}

TEST(main_value, takes_percent_with_any_exponent)
{
    for (int exponent = -128; exponent <= 127; ++exponent) {
        auto const e = static_cast<std::int8_t>(exponent);
        EXPECT_EQ(reference::make(percent{0, e})->raw(), 0) << exponent;
        auto const one = reference::make(percent{1, e});
        EXPECT_EQ(one.has_value(), exponent <= 2) << exponent;  // 100 %, but no 1000 %
        auto const most = reference::make(percent{0x7FFFFFFF, e});
        EXPECT_EQ(most.has_value(), exponent <= -8) << exponent;  // 21.47 %, but no 214.7 %
        if (exponent < -16) { EXPECT_EQ(most->raw(), 0) << exponent; }
    }
    VERIFY(reference::make(percent{1, 2})->raw() == 0x4000);
    VERIFY(reference::make(percent{-0x7FFFFFFF - 1, -7}).error() == beyond);
}

//=== frequency ===//

struct limits {
    hertz lower;
    hertz upper;
};
constexpr limits all_limits[]{
    {{0, 0}, {50, 0}},  {{0, 0}, {1000, -1}},    {{0, 0}, {120, 0}},
    {{10, 0}, {50, 0}}, {{105, -1}, {6000, -2}}, {{0, 0}, {1, 3}},
};

TEST(main_value, as_frequency_is_the_nearest_step_between_the_limits)
{
    for (auto const [lower, upper] : all_limits) {
        auto const low  = *lower.scaled_to(-3);
        auto const span = *upper.scaled_to(-3) - low;
        for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
            auto const given = output_frequency::from_raw(static_cast<std::uint16_t>(raw));
            auto const read  = given.frequency(lower, upper);
            ASSERT_EQ(read.has_value(), raw != 0x8000);
            if (not read) { continue; }
            auto const steps  = given.number() < 0 ? -given.number() : given.number();
            auto const wanted = low + static_cast<std::int32_t>(nearest(std::int64_t{steps} * span, 16384));
            ASSERT_EQ(read->number, given.number() < 0 ? -wanted : wanted) << raw;
            ASSERT_EQ(read->exponent, -3);
        }
    }
}

TEST(main_value, survives_as_frequency_with_every_number)
{
    for (auto const [lower, upper] : all_limits) {
        for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
            if (raw == 0x8000) { continue; }
            auto const given = output_frequency::from_raw(static_cast<std::uint16_t>(raw));
            auto const again = output_frequency::make(*given.frequency(lower, upper, -4), lower, upper);
            ASSERT_TRUE(again) << raw;
            ASSERT_EQ(again->raw(), raw) << raw;
        }
    }
}

TEST(main_value, of_every_frequency_is_the_nearest_number)
{
    for (auto const [lower, upper] : all_limits) {
        auto const low  = *lower.scaled_to(-3);
        auto const span = *upper.scaled_to(-3) - low;
        for (std::int32_t thousandths = -2 * (low + span) - 100; thousandths <= 2 * (low + span) + 100;
             thousandths += 7) {
            auto const made      = reference::make(hertz{thousandths, -3}, lower, upper);
            auto const magnitude = (thousandths < 0 ? -thousandths : thousandths) - low;
            auto const number    = nearest(std::int64_t{magnitude} * 16384, span);
            auto const is_lost   = thousandths < 0 and number == 0 and low != 0;  // there is no negative zero
            auto const fits      = magnitude >= 0 and number <= 32767 and not is_lost;
            ASSERT_EQ(made.has_value(), fits) << thousandths;
            if (fits) {
                ASSERT_EQ(made->number(), static_cast<int>(thousandths < 0 ? -number : number)) << thousandths;
            } else {
                ASSERT_EQ(made.error(), beyond);
            }
        }
    }
}

// The manual gives no meaning to the sign when the minimum is not 0: here it is the direction.
TEST(main_value, with_a_minimum_has_its_sign_as_the_direction)
{
    VERIFY(*reference::from_raw(0).frequency(10_Hz, 50_Hz) == 10_Hz);
    VERIFY(*reference::from_raw(0x2000).frequency(10_Hz, 50_Hz) == 30_Hz);
    VERIFY(*reference::from_raw(0xE000).frequency(10_Hz, 50_Hz) == -30_Hz);
    VERIFY(*reference::from_raw(0x4000).frequency(10_Hz, 50_Hz) == 50_Hz);
    VERIFY(reference::make(30_Hz, 10_Hz, 50_Hz)->raw() == 0x2000);
    VERIFY(reference::make(-30_Hz, 10_Hz, 50_Hz)->raw() == 0xE000);
    VERIFY(reference::make(10_Hz, 10_Hz, 50_Hz)->raw() == 0);
    VERIFY(reference::make(9.999_Hz, 10_Hz, 50_Hz).error() == beyond);
    VERIFY(reference::make(0_Hz, 10_Hz, 50_Hz).error() == beyond);
    VERIFY(reference::make(-9_Hz, 10_Hz, 50_Hz).error() == beyond);
    VERIFY(reference::make(-10_Hz, 10_Hz, 50_Hz).error() == beyond);  // would be negative zero
    VERIFY(reference::make(-10.001_Hz, 10_Hz, 50_Hz).error() == beyond);
    VERIFY(reference::make(-10.002_Hz, 10_Hz, 50_Hz)->raw() == 0xFFFF);
    VERIFY(reference::make(-0.001_Hz, 0_Hz, 50_Hz)->raw() == 0);  // 0 Hz has no direction
}

TEST(main_value, refuses_limits_that_are_not_ascending_from_0_on)
{
    VERIFY(reference::make(5_Hz, 50_Hz, 50_Hz).error() == beyond);
    VERIFY(reference::make(5_Hz, 50_Hz, 10_Hz).error() == beyond);
    VERIFY(reference::make(5_Hz, -1_Hz, 50_Hz).error() == beyond);
    VERIFY(reference::from_raw(1).frequency(50_Hz, 50_Hz).error() == beyond);
    VERIFY(reference::from_raw(1).frequency(50_Hz, 10_Hz).error() == beyond);
    VERIFY(reference::from_raw(1).frequency(-1_Hz, 50_Hz).error() == beyond);
}

TEST(main_value, refuses_frequencies_beyond_the_ends)
{
    VERIFY(reference::make(99.997_Hz, 0_Hz, 50_Hz)->raw() == 0x7FFF);   // 32767.02
    VERIFY(reference::make(99.999_Hz, 0_Hz, 50_Hz).error() == beyond);  // 32767.67
    VERIFY(reference::make(-99.997_Hz, 0_Hz, 50_Hz)->raw() == 0x8001);
    VERIFY(reference::make(100_Hz, 0_Hz, 50_Hz).error() == beyond);
    VERIFY(reference::make(2'000'000'000_Hz, 0_Hz, 1_Hz).error() == beyond);
    VERIFY(reference::make(hertz{1, 100}, 0_Hz, 50_Hz).error() == beyond);
}

TEST(main_value, refuses_steps_that_are_too_coarse_for_the_limits_or_too_fine_for_32_bits)
{
    VERIFY(reference::from_raw(0x4000).frequency(0.5_Hz, 50_Hz, 0).error() == error{errc::inexact, 0});
    VERIFY(reference::from_raw(0x4000).frequency(0_Hz, 50_Hz, -9).error() == beyond);
    VERIFY(reference::from_raw(0x4000).frequency(0_Hz, 2_Hz, -9)->number == 2'000'000'000);
    VERIFY(reference::from_raw(0x7FFF).frequency(0_Hz, 2_Hz, -9).error() == beyond);
    VERIFY(reference::from_raw(0x8001).frequency(0_Hz, 2_Hz, -9).error() == beyond);
    VERIFY(reference::from_raw(0x4000).frequency(0_Hz, hertz{0x7FFFFFFF, 0}, 0)->number == 0x7FFFFFFF);
    VERIFY(reference::from_raw(0xC000).frequency(0_Hz, hertz{0x7FFFFFFF, 0}, 0)->number == -0x7FFFFFFF);
}

TEST(main_value, refuses_frequencies_that_32_bits_do_not_hold_with_the_digits_of_the_finest)
{
    constexpr hertz fine_50{500'000'000, -7};
    VERIFY(reference::make(fine_50, 0_Hz, 200_Hz)->raw() == 0x1000);
    VERIFY(reference::make(fine_50, 0_Hz, 400_Hz).error() == beyond);
    VERIFY(reference::make(50_Hz, 0_Hz, 400_Hz)->raw() == 0x0800);
    VERIFY(reference::make(50_Hz, hertz{0, -100}, 400_Hz)->raw() == 0x0800);  // a zero has all digits
}

TEST(main_value, is_a_reference_or_an_output_frequency_never_the_other)
{
    VERIFY(not std::is_convertible_v<reference, output_frequency>);
    VERIFY(not std::is_convertible_v<output_frequency, reference>);
    static constexpr reference forwards  = 50_percent;
    static constexpr reference backwards = -50_percent;
    VERIFY(forwards == reference::from_raw(0x2000));
    VERIFY(forwards != backwards);
}

TEST(main_value, of_hertz_takes_a_zero_of_whatever_digits)
{
    constexpr quantity<unit::hertz> fine_zero{0, -12};
    constexpr quantity<unit::hertz> coarse_zero{0, 9};
    VERIFY(reference::make(25_Hz, fine_zero, 50_Hz)->raw() == 0x2000);
    VERIFY(reference::make(25_Hz, coarse_zero, 50.0_Hz)->raw() == 0x2000);
    VERIFY(reference::make(fine_zero, coarse_zero, 50_Hz)->raw() == 0);
}

}  // namespace
