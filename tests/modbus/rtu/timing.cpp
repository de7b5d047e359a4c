#include <drivecodec/modbus/rtu/timing.hpp>

#include "support/verify.hpp"

#include <limits>

namespace {

namespace rtu = drivecodec::modbus::rtu;
using drivecodec::errc;
using drivecodec::error;
using rtu::timing;

//=== characters ===//

TEST(rtu_character_format, counts_all_bits_of_a_character)
{
    VERIFY(rtu::format_8e1.bits_per_character() == 11);
    VERIFY(rtu::format_8o1.bits_per_character() == 11);
    VERIFY(rtu::format_8n2.bits_per_character() == 11);
    VERIFY(rtu::format_8n1.bits_per_character() == 10);
    VERIFY(rtu::character_format{rtu::parity::even, rtu::stop_bits::two}.bits_per_character() == 12);
}

TEST(rtu_character_format, is_8e1_unless_told_otherwise)
{
    VERIFY(rtu::character_format{} == rtu::format_8e1);
    VERIFY(timing::of(9600) == timing::of(9600, rtu::format_8e1));
    VERIFY(timing::of(9600) != timing::of(9600, rtu::format_8n1));
}

//=== silences ===//

TEST(rtu_timing, rounds_up_to_microseconds)
{
    VERIFY(timing::of(9600).character() == 1146);        // 1145.8
    VERIFY(timing::of(9600).inter_character() == 1719);  // 1718.75
    VERIFY(timing::of(9600).inter_frame() == 4011);      // 4010.4

    VERIFY(timing::of(19200).character() == 573);        // 572.9
    VERIFY(timing::of(19200).inter_character() == 860);  // 859.4
    VERIFY(timing::of(19200).inter_frame() == 2006);     // 2005.2
}

TEST(rtu_timing, adds_nothing_to_whole_microseconds)
{
    VERIFY(timing::of(1000, rtu::format_8n1).character() == 10'000);
    VERIFY(timing::of(1000, rtu::format_8n1).inter_character() == 15'000);
    VERIFY(timing::of(1000, rtu::format_8n1).inter_frame() == 35'000);
}

TEST(rtu_timing, has_fixed_silences_above_19200_baud)
{
    VERIFY(timing::of(19201).inter_character() == 750);
    VERIFY(timing::of(19201).inter_frame() == 1750);
    VERIFY(timing::of(115200).inter_character() == 750);
    VERIFY(timing::of(115200).inter_frame() == 1750);
    VERIFY(timing::of(115200).character() == 96);  // 95.5
}

TEST(rtu_timing, knows_how_long_a_frame_takes)
{
    VERIFY(timing::of(9600).frame_time(0) == 0);
    VERIFY(timing::of(9600).frame_time(8) == 9167);  // 9166.7: not eight times the rounded character
    VERIFY(timing::of(9600).frame_time(256) == 293'334);
    VERIFY(timing::of(115200, rtu::format_8n1).frame_time(256) == 22'223);
}

//=== limits ===//

TEST(rtu_timing, refuses_a_baud_rate_of_zero)
{
    VERIFY(timing::make(0).error() == error{errc::bad_value, 0});
    VERIFY(*timing::make(9600, rtu::format_8n1) == timing::of(9600, rtu::format_8n1));
}

TEST(rtu_timing, does_not_overflow)
{
    constexpr rtu::character_format longest{rtu::parity::odd, rtu::stop_bits::two};
    VERIFY(timing::of(1, longest).frame_time(256) == 3'072'000'000);
    VERIFY(timing::of(1, longest).inter_frame() == 42'000'000);
    VERIFY(timing::make(std::numeric_limits<std::uint32_t>::max())->frame_time(256) == 1);
    VERIFY(timing::make(std::numeric_limits<std::uint32_t>::max())->inter_frame() == 1750);
}

TEST(rtu_timing, is_exact_at_every_scaled_baud_rate)
{
    auto const rounded_up = [](std::uint64_t over, std::uint64_t under) { return (over + under - 1) / under; };
    for (auto const format : {rtu::format_8e1, rtu::format_8n1}) {
        std::uint64_t const bits = format.bits_per_character();
        for (std::uint32_t baud = 1; baud <= timing::fastest_scaled_baud; ++baud) {
            auto const made = *timing::make(baud, format);
            ASSERT_EQ(made.character(), rounded_up(bits * 1'000'000, baud)) << baud;
            ASSERT_EQ(made.inter_character(), rounded_up(bits * 1'500'000, baud)) << baud;
            ASSERT_EQ(made.inter_frame(), rounded_up(bits * 3'500'000, baud)) << baud;
            ASSERT_EQ(made.frame_time(256), rounded_up(256 * bits * 1'000'000, baud)) << baud;
        }
    }
}

}  // namespace
