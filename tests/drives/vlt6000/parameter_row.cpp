#include <drivecodec/drives/vlt6000/parameter_row.hpp>

#include "support/verify.hpp"

#include <array>
#include <type_traits>

namespace {

using namespace drivecodec;
using vlt6000::access;  // by itself, for unistd.h has one, too
using vlt6000::kind;
using vlt6000::parameter_row;
using vlt6000::stated;
using vlt6000::value_limits;

constexpr error read_only{errc::read_only, 0};
constexpr error out_of_range{errc::out_of_range, 0};

constexpr std::array<std::uint16_t, 2> codes{1, 4};

constexpr parameter_row row_of(access may, kind what = kind::number)
{
    return {.number = 1, .kind = what, .access = may, .max_text_length = 8};
}

TEST(vlt6000_parameter_row, knows_what_is_stated_and_no_more)
{
    constexpr stated<std::int8_t> nothing;
    constexpr stated<std::int8_t> zero{std::int8_t{0}};
    VERIFY(not nothing and zero and *zero == 0);
    VERIFY(nothing != zero and zero != stated<std::int8_t>{std::int8_t{1}} and zero == stated<std::int8_t>{0});
    VERIFY(std::is_trivially_copyable_v<stated<decimal>>);

    constexpr parameter_row bare{.number = 1};
    VERIFY(bare.name.empty() and bare.display_text.empty());
    VERIFY(bare.kind == kind::unknown);
    VERIFY(bare.access == access::unknown);  // apart: g++ 12 for s390x breaks down on both at once
    VERIFY(not bare.width and not bare.data_type and not bare.conversion_index);
    VERIFY(not bare.limits and not bare.factory_setting and bare.choices.empty());
    VERIFY(bare.unit == unit::none and bare.unit_selected_in == 0 and bare.update_interval == 0);
    VERIFY(bare.check({-1, 0}).ok() and bare.check_write({1'000'000, 0}).ok());
}

TEST(vlt6000_parameter_row, is_a_constant_that_a_template_can_have)
{
    constexpr auto index = std::integral_constant<std::int8_t, *stated<std::int8_t>{std::int8_t{-1}}>::value;
    VERIFY(index == -1);
}

TEST(vlt6000_parameter_row, is_writable_unless_the_manual_says_no)
{
    VERIFY(row_of(access::unknown).is_writable() and row_of(access::unknown).check_write().ok());
    VERIFY(row_of(access::read_write).is_writable() and row_of(access::read_write).check_write().ok());
    VERIFY(row_of(access::write_only).is_writable() and row_of(access::write_only).check_write().ok());
    VERIFY(not row_of(access::read_only).is_writable() and row_of(access::read_only).check_write() == read_only);
    VERIFY(not row_of(access::panel_only).is_writable() and row_of(access::panel_only).check_write() == read_only);
}

TEST(vlt6000_parameter_row, scales_by_conversion_index_and_prefix)
{
    constexpr parameter_row tenths{.number = 202, .conversion_index = -1, .unit = unit::hertz};
    VERIFY(tenths.value(1000).number == 1000 and tenths.value(1000).exponent == -1);

    constexpr parameter_row kilowatts{.number = 1, .conversion_index = -2, .unit = unit::watt, .unit_prefix = 3};
    VERIFY(kilowatts.value(150) == decimal{1500, 0});  // 1.50 kW

    constexpr parameter_row milliamperes{.number = 1, .conversion_index = 0, .unit_prefix = -3};
    VERIFY(milliamperes.value(20) == decimal{20, -3});
    VERIFY(milliamperes.value(-20) == decimal{-20, -3});
}

TEST(vlt6000_parameter_row, takes_what_is_within_its_limits_whatever_the_digits)
{
    constexpr parameter_row seconds{.number = 555, .limits = value_limits{{1, 0}, {65534, 0}}};
    VERIFY(seconds.check({1, 0}).ok() and seconds.check({65534, 0}).ok() and seconds.check({655340, -1}).ok());
    VERIFY(seconds.check({0, 0}) == out_of_range and seconds.check({65535, 0}) == out_of_range);
    VERIFY(seconds.check({9, -1}) == out_of_range and seconds.check({655341, -1}) == out_of_range);
    VERIFY(seconds.check({-1, 0}) == out_of_range and seconds.check({66, 3}) == out_of_range);
    for (int value = -1; value <= 70'000; ++value) {
        ASSERT_EQ(seconds.check({value, 0}).ok(), value >= 1 and value <= 65534) << value;
    }
}

TEST(vlt6000_parameter_row, takes_its_choices_and_others_only_if_there_are_more_than_printed)
{
    constexpr parameter_row all{.number = 1, .kind = kind::choice, .choices = codes};
    constexpr parameter_row some{.number = 1, .kind = kind::choice, .choices = codes, .has_other_choices = true};
    for (std::int32_t raw = 0; raw <= 0xFFFF; ++raw) {
        ASSERT_EQ(all.check({raw, 0}).ok(), raw == 1 or raw == 4) << raw;
        ASSERT_TRUE(some.check({raw, 0}).ok()) << raw;
    }
    VERIFY(all.check({15, -1}) == out_of_range);
}

TEST(vlt6000_parameter_row, refuses_a_write_by_access_first)
{
    constexpr parameter_row locked{.number = 1, .access = access::panel_only, .limits = value_limits{{0, 0}, {126, 0}}};
    VERIFY(locked.check({127, 0}) == out_of_range and locked.check_write({127, 0}) == read_only);
    VERIFY(locked.check_write({1, 0}) == read_only);

    constexpr parameter_row open{.number = 1, .access = access::read_write, .limits = value_limits{{0, 0}, {126, 0}}};
    VERIFY(open.check_write({126, 0}).ok() and open.check_write({127, 0}) == out_of_range);
}

TEST(vlt6000_parameter_row, takes_texts_if_it_is_one)
{
    VERIFY(row_of(access::write_only, kind::text).check_text(0).ok());
    VERIFY(row_of(access::write_only, kind::text).check_text(8).ok());
    VERIFY(row_of(access::write_only, kind::text).check_text(9) == out_of_range);
    VERIFY(row_of(access::write_only, kind::number).check_text(1) == out_of_range);
    VERIFY(row_of(access::unknown, kind::unknown).check_text(0) == out_of_range);
    VERIFY(row_of(access::read_only, kind::text).check_text(9) == read_only);
    VERIFY(row_of(access::write_only, kind::text).check({0, 0}) == out_of_range);
}

}  // namespace
