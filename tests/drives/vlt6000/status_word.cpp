#include <drivecodec/drives/vlt6000/status_word.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::vlt6000;

constexpr status_word word_of(unsigned raw)
{
    return status_word::from_raw(static_cast<std::uint16_t>(raw));
}

// VLT 6000 manual, "Status word as per FC protocol": each bit.
static_assert(status_word::of(status_word::control_ready).raw == 0x0001);
static_assert(status_word::of(status_word::drive_ready).raw == 0x0002);
static_assert(status_word::of(status_word::stand_by).raw == 0x0004);
static_assert(status_word::of(status_word::tripped).raw == 0x0008);
static_assert(status_word::of(status_word::not_used_4).raw == 0x0010);
static_assert(status_word::of(status_word::not_used_5).raw == 0x0020);
static_assert(status_word::of(status_word::not_used_6).raw == 0x0040);
static_assert(status_word::of(status_word::warning).raw == 0x0080);
static_assert(status_word::of(status_word::speed_equals_reference).raw == 0x0100);
static_assert(status_word::of(status_word::serial_control).raw == 0x0200);
static_assert(status_word::of(status_word::within_frequency_range).raw == 0x0400);
static_assert(status_word::of(status_word::running).raw == 0x0800);
static_assert(status_word::of(status_word::no_function_12).raw == 0x1000);
static_assert(status_word::of(status_word::voltage_warning).raw == 0x2000);
static_assert(status_word::of(status_word::current_limit).raw == 0x4000);
static_assert(status_word::of(status_word::thermal_warning).raw == 0x8000);

// The manual's example of a drive that runs at 50 % of its frequency range.
constexpr auto running_example = word_of(0x0F03);

TEST(vlt6000_status_word, reads_the_manual_s_example)
{
    VERIFY(running_example
           == status_word::of(status_word::control_ready, status_word::drive_ready, status_word::speed_equals_reference,
                              status_word::serial_control, status_word::within_frequency_range, status_word::running));
    VERIFY(not running_example.is_local());
}

TEST(vlt6000_manual, says_of_drive_ready_that_the_drive_coasts_but_sets_it_in_the_example_that_runs)
{
    VERIFY(running_example.test(status_word::drive_ready) and running_example.test(status_word::running));
}

TEST(vlt6000_manual, has_no_stand_by_in_the_example_that_runs)
{
    // So a 0 there does not mean that a start would be refused.
    VERIFY(not running_example.test(status_word::stand_by) and running_example.test(status_word::running));
}

TEST(vlt6000_manual, calls_bit_10_out_of_frequency_range_where_1_is_within)
{
    // 25 Hz between 0 and 50 Hz has a 1.
    VERIFY(running_example.test(status_word::within_frequency_range));
    VERIFY(not word_of(0x0B03).test(status_word::within_frequency_range));
}

TEST(vlt6000_manual, says_that_the_motor_runs_where_the_speed_differs_from_the_reference)
{
    // Of a motor that stands the bit may be 0, too: only bit 11 says whether it runs.
    constexpr auto at_rest = word_of(0x0607);
    VERIFY(not at_rest.test(status_word::speed_equals_reference) and not at_rest.test(status_word::running));
    VERIFY(not word_of(0x0E03).test(status_word::speed_equals_reference)
           and word_of(0x0E03).test(status_word::running));
}

TEST(vlt6000_status_word, keeps_every_bit_that_it_is_given)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = word_of(raw);
        ASSERT_EQ(word.raw, raw);
        ASSERT_EQ(word.with(status_word::no_function_12).without(status_word::no_function_12).raw, raw & ~0x1000U);
        ASSERT_EQ(word.test(status_word::tripped), (raw >> 3 & 1U) != 0);
        ASSERT_EQ(word.is_local(), (raw >> 9 & 1U) == 0);
    }
}

}  // namespace
