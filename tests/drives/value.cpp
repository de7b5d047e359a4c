#include <drivecodec/drives/value.hpp>

#include "support/lamps.hpp"
#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec;
using namespace drivecodec::drives;
using namespace drivecodec::literals;

constexpr auto forty_hertz       = 40_Hz;
constexpr auto forty_one_hertz   = 41.2_Hz;
constexpr auto too_many_digits   = 41.25_Hz;
constexpr auto too_much_by_far   = 2'000'000'000_Hz;
constexpr auto minus_three_hertz = -0.3_Hz;

TEST(value, is_a_quantity_a_word_or_neither)
{
    VERIFY(is_quantity<quantity<unit::hertz>> and not is_word<quantity<unit::hertz>>);
    VERIFY(is_word<lamps> and not is_quantity<lamps>);
    VERIFY(not is_quantity<colour> and not is_word<colour>);
    VERIFY(not is_quantity<std::int32_t> and not is_word<std::int32_t>);
}

TEST(value, of_a_quantity_is_the_count_of_its_steps)
{
    VERIFY(number_of(forty_hertz, -1) == result<std::int32_t>{400}
           and number_of(forty_hertz, 1) == result<std::int32_t>{4});
    VERIFY(number_of(forty_one_hertz, -1) == result<std::int32_t>{412});
    VERIFY(number_of(minus_three_hertz, -1) == result<std::int32_t>{-3});
    VERIFY(number_of(too_many_digits, -1).error() == error{errc::inexact, 0});
    VERIFY(number_of(too_much_by_far, -1).error() == error{errc::out_of_range, 0});
    VERIFY(value_of<quantity<unit::hertz>>(412, -1) == forty_one_hertz);
    VERIFY(value_of<quantity<unit::hertz>>(412, -1).exponent == -1);
}

TEST(value, of_all_else_is_the_number_whatever_the_exponent)
{
    for (std::int32_t number = 0; number <= 0xFFFF; ++number) {
        auto const wanted = result<std::int32_t>{number};
        ASSERT_EQ(number_of(value_of<colour>(number, -1), -1), wanted);
        ASSERT_EQ(number_of(value_of<lamps>(number, 0), 3), wanted);
        ASSERT_EQ(number_of(value_of<std::uint16_t>(number, 0), -3), wanted);
        ASSERT_EQ(number_of(value_of<std::int32_t>(-number, 0), 0), result<std::int32_t>{-number});
    }
    VERIFY(number_of(colour::last, 0) == result<std::int32_t>{0xFFFF});
    VERIFY(value_of<lamps>(0xFFFE, 0).raw == 0xFFFE and value_of<lamps>(3, 0).test(lamps::red));
}

TEST(value, of_its_own_type)
{
    struct of_the_drive : value_is<colour> {};
    VERIFY(std::is_same_v<of_the_drive::type, colour>);
}

TEST(value, is_one_of_the_codes_whatever_its_digits)
{
    static constexpr std::array<std::uint16_t, 3> codes{1, 4, 0xFFFF};
    for (std::int32_t number = -1; number <= 0x1FFFF; ++number) {
        auto const expected = number == 1 or number == 4 or number == 0xFFFF;
        ASSERT_EQ(is_one_of(codes, number), expected) << number;
        ASSERT_EQ(is_one_of(codes, decimal{number, 0}), expected) << number;
    }
    VERIFY(is_one_of(codes, decimal{40, -1}) and not is_one_of(codes, decimal{41, -1}));
    VERIFY(not is_one_of({}, 0));
}

TEST(require, lets_pass_what_is_allowed)
{
    constexpr auto passed = [] {
        require_writable<access::unknown>();
        require_writable<access::read_write>();
        require_writable<access::read_write_at_standstill>();
        require_writable<access::write_only>();
        require_readable<access::read_only>();
        require_readable<access::panel_only>();
        return true;
    }();
    VERIFY(passed);
}

}  // namespace
