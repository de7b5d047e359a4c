#include <drivecodec/drives/vlt6000/transfer.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::vlt6000;
using fc::data_type;

constexpr transfer unsaid_word{.width = fc::width::word};
constexpr transfer unsaid_double_word{.width = fc::width::double_word};

[[nodiscard]] constexpr fc::parameter_response response(unsigned ak, std::uint32_t pwe)
{
    return {fc::pke::from_raw(static_cast<std::uint16_t>(ak << 12 | 202)), {}, pwe, {}};
}

TEST(transfer, what_the_user_says_has_width_sign_and_scale)
{
    VERIFY(transfer::as(data_type::integer_16, -1)
           == transfer{fc::width::word, data_type::integer_16, std::int8_t{-1}});
    VERIFY(transfer::as(data_type::unsigned_32, 2)
           == transfer{fc::width::double_word, data_type::unsigned_32, std::int8_t{2}});
}

TEST(transfer, of_the_conversion_indexes_those_from_minus_7_to_6_are_powers_of_ten)
{
    for (int index = -1000; index <= 1000; ++index) {
        EXPECT_EQ(is_power_of_ten(index), index >= -7 and index <= 6) << index;
    }
    VERIFY(not is_power_of_ten(74));
    VERIFY(transfer::as(data_type::unsigned_8, {}) == transfer{fc::width::word, data_type::unsigned_8, {}});
}

TEST(transfer, numbers_have_the_ends_of_their_type)
{
    constexpr auto ends_are = [](transfer how, std::int32_t min, std::int32_t max) {
        return limits_of(how).min == min and limits_of(how).max == max;
    };
    VERIFY(ends_are(transfer::as(data_type::unsigned_8, 0), 0, 255));
    VERIFY(ends_are(transfer::as(data_type::unsigned_16, 0), 0, 65535));
    VERIFY(ends_are(transfer::as(data_type::integer_16, 0), -32768, 32767));
    VERIFY(ends_are(transfer::as(data_type::integer_32, 0), -2147483647 - 1, 2147483647));
    VERIFY(ends_are(transfer::as(data_type::unsigned_32, 0), 0, 2147483647));
}

TEST(transfer, without_a_sign_stated_only_what_both_signs_have_in_common)
{
    VERIFY(*pwe_for(0x7FFF, unsaid_word) == 0x7FFF);
    VERIFY(pwe_for(0x8000, unsaid_word).error() == error{errc::out_of_range, 0});
    VERIFY(pwe_for(-1, unsaid_word).error() == error{errc::out_of_range, 0});
    VERIFY(*number_in(response(1, 0x7FFF), unsaid_word) == 0x7FFF);
    VERIFY(number_in(response(1, 0x8000), unsaid_word).error() == error{errc::out_of_range, 0});
    VERIFY(*number_in(response(2, 0x7FFFFFFF), unsaid_double_word) == 0x7FFFFFFF);
    VERIFY(number_in(response(2, 0x80000000), unsaid_double_word).error() == error{errc::out_of_range, 0});
}

TEST(transfer, of_what_is_read_the_reply_tells_the_width)
{
    VERIFY(*number_in(response(2, 100'000), unsaid_word) == 100'000);
    VERIFY(*number_in(response(2, 100'000), transfer{}) == 100'000);
    VERIFY(*number_in(response(1, 1000), transfer{}) == 1000);
}

TEST(transfer, a_stated_type_must_come_in_its_own_width)
{
    constexpr auto word        = transfer::as(data_type::integer_16, 0);
    constexpr auto double_word = transfer::as(data_type::integer_32, 0);
    VERIFY(number_in(response(2, 1), word).error() == error{errc::bad_value, 0});
    VERIFY(number_in(response(1, 1), double_word).error() == error{errc::bad_value, 0});
    VERIFY(*number_in(response(1, 0xFFFF), word) == -1);
    VERIFY(*number_in(response(2, 0xFFFFFFFF), double_word) == -1);
    VERIFY(number_in(response(2, 0xFFFFFFFF), transfer::as(data_type::unsigned_32, 0)).error()
           == error{errc::out_of_range, 0});
}

TEST(transfer, every_16_bit_number_comes_back)
{
    for (std::int32_t number = -0x8000; number <= 0xFFFF; ++number) {
        for (auto const type : {data_type::integer_16, data_type::unsigned_16}) {
            auto const how       = transfer::as(type, 0);
            auto const is_inside = type == data_type::integer_16 ? number <= 0x7FFF : number >= 0;
            auto const pwe       = pwe_for(number, how);
            ASSERT_EQ(pwe.has_value(), is_inside) << number;
            if (not pwe) { continue; }
            ASSERT_EQ(*pwe, static_cast<std::uint32_t>(number) & 0xFFFFU);
            ASSERT_EQ(*number_in(response(1, *pwe), how), number);
        }
    }
}

TEST(transfer, nothing_is_a_number_that_brings_no_value)
{
    for (unsigned ak = 0; ak <= 0xF; ++ak) {
        auto const has_value = ak == 1 or ak == 2;
        EXPECT_EQ(number_in(response(ak, 5), {}).has_value(), has_value) << ak;
        EXPECT_EQ(bits_in(response(ak, 5), 16).has_value(), has_value) << ak;
    }
}

TEST(transfer, bits_come_in_either_width_and_none_is_lost)
{
    VERIFY(*bits_in(response(1, 0x0F03), 16) == 0x0F03);
    VERIFY(*bits_in(response(2, 0x0F03), 16) == 0x0F03);
    VERIFY(bits_in(response(2, 0x10F03), 16).error() == error{errc::out_of_range, 0});
    VERIFY(*bits_in(response(2, 0xFFFFFFFF), 32) == 0xFFFFFFFF);
}

}  // namespace
