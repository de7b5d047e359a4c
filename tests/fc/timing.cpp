#include <drivecodec/fc/timing.hpp>

#include "support/verify.hpp"

#include <limits>

namespace {

using drivecodec::errc;
using drivecodec::error;
using drivecodec::fc::bits_per_character;
using drivecodec::fc::fc_baud_rates;
using drivecodec::fc::timing;
using drivecodec::fc::vlt_baud_rates;

//=== the manual's numbers ===//

// "Contents of a character (byte)": start bit, 8 data bits, parity bit, stop bit.
TEST(timing, has_characters_of_11_bits)
{
    VERIFY(bits_per_character == 1 + 8 + 1 + 1);
    VERIFY(timing::of(11).character() == 1'000'000);
}

// "If the baudrate is 9600 baud and the telegram length is 16 bytes, the telegram must be completed within 27.5 msec."
TEST(timing, of_16_bytes_at_9600_baud_is_27_5_ms)
{
    VERIFY(timing::of(9600).telegram_limit(16) == 27'500);
}

// "A minimum pause of 2 characters (22 bits)"; "at a baudrate of 9600 baud ... 2.3 msec."
TEST(timing, has_a_pause_of_2_3_ms_at_9600_baud)
{
    VERIFY(timing::of(9600).pause() == 2292);  // 2291.67
    VERIFY(timing::of(9600).silence() == 3438);  // 3437.5: two characters, and one that is seen when it is complete
    VERIFY((timing::of(9600).pause() + 50) / 100 == 23);
}

// The time between characters is "not to exceed 2 characters", the pause is "2 characters" at least.
TEST(timing, has_two_characters_as_the_limit_of_a_gap_and_of_a_pause)
{
    for (auto const baud : vlt_baud_rates) {
        EXPECT_EQ(timing::make(baud)->gap(), timing::make(baud)->pause()) << baud;
    }
    VERIFY(timing::of(300).gap() == 73'334);  // 73333.3
}

// "The response time of the slaves is max. 50 ms"; an earlier edition of the manual has 20 ms.
TEST(timing, waits_50_ms_for_a_response_although_an_edition_says_20)
{
    VERIFY(timing::response_limit == 50'000);
}

//=== every baud rate ===//

// Parameter 502.
TEST(timing, knows_the_baud_rates_of_parameter_502)
{
    VERIFY(vlt_baud_rates == std::array<std::uint32_t, 6>{300, 600, 1200, 2400, 4800, 9600});
    VERIFY(fc_baud_rates == std::array<std::uint32_t, 7>{2400, 4800, 9600, 19200, 38400, 57600, 115200});
}

struct row {
    std::uint32_t baud;
    std::uint32_t character;
    std::uint32_t pause;
    std::uint32_t telegram_16;
    std::uint32_t limit_16;
};
// 11, 22, 176 and 264 bits, in microseconds rounded up; by hand.
constexpr row rows[]{
    {300, 36'667, 73'334, 586'667, 880'000}, {600, 18'334, 36'667, 293'334, 440'000},
    {1200, 9167, 18'334, 146'667, 220'000},  {2400, 4584, 9167, 73'334, 110'000},
    {4800, 2292, 4584, 36'667, 55'000},      {9600, 1146, 2292, 18'334, 27'500},
    {19200, 573, 1146, 9167, 13'750},        {38400, 287, 573, 4584, 6875},
    {57600, 191, 382, 3056, 4584},           {115200, 96, 191, 1528, 2292},
};

TEST(timing, is_right_for_every_baud_rate)
{
    for (auto const& row : rows) {
        auto const made = *timing::make(row.baud);
        EXPECT_EQ(made.character(), row.character) << row.baud;
        EXPECT_EQ(made.gap(), row.pause) << row.baud;
        EXPECT_EQ(made.pause(), row.pause) << row.baud;
        EXPECT_EQ(made.telegram(16), row.telegram_16) << row.baud;
        EXPECT_EQ(made.telegram_limit(16), row.limit_16) << row.baud;
    }
}

TEST(timing, is_rounded_up_for_every_size)
{
    // The least count of microseconds within which so many bits have passed.
    auto const is_least = [](std::uint64_t microseconds, std::uint64_t half_bits, std::uint64_t baud) {
        auto const needed = half_bits * 500'000;
        return microseconds * baud >= needed and (microseconds == 0 or (microseconds - 1) * baud < needed);
    };
    for (std::uint32_t const baud : {1U, 7U, 300U, 9600U, 57600U, 115200U, 1'000'000U, 11'000'000U, 4'294'967'295U}) {
        auto const made = *timing::make(baud);
        for (std::size_t size = 0; size <= 256; ++size) {
            ASSERT_TRUE(is_least(made.telegram(size), size * 22, baud)) << baud << ' ' << size;
            ASSERT_TRUE(is_least(made.telegram_limit(size), size * 33, baud)) << baud << ' ' << size;
        }
        ASSERT_TRUE(is_least(made.character(), 22, baud)) << baud;
        ASSERT_TRUE(is_least(made.pause(), 44, baud)) << baud;
    }
}

TEST(timing, does_not_overflow)
{
    VERIFY(timing::of(1).telegram(256) == 2'816'000'000);
    VERIFY(timing::of(1).telegram_limit(256) == 4'224'000'000);
    VERIFY(timing::make(std::numeric_limits<std::uint32_t>::max())->telegram_limit(256) == 1);
}

//=== limits ===//

TEST(timing, refuses_a_baud_rate_of_zero)
{
    VERIFY(timing::make(0).error() == error{errc::bad_value, 0});
    VERIFY(*timing::make(9600) == timing::of(9600));
    VERIFY(timing::of(9600) != timing::of(4800));
}

}  // namespace
