#include <drivecodec/drives/vlt6000/extended_status_word.hpp>
#include <drivecodec/drives/vlt6000/warning_word.hpp>

#include "support/verify.hpp"

#include <type_traits>

namespace {

using namespace drivecodec::vlt6000;

using state = extended_status_word;

// VLT 6000 manual, "Warning words 1+2 and Alarm word", table "Extended status word": each code with the manual's words.
// clang-format off
static_assert(state::of(state::overvoltage_control_active).raw == 0x0000'0001);  // Overvoltage control active
static_assert(state::of(state::start_delay).raw == 0x0000'0002);  // Start delay
static_assert(state::of(state::sleep_boost_active).raw == 0x0000'0004);  // Sleep boost active
static_assert(state::of(state::sleep_mode_active).raw == 0x0000'0008);  // Sleep mode active
static_assert(state::of(state::automatic_motor_adaptation_completed).raw == 0x0000'0010);
static_assert(state::of(state::automatic_motor_adaptation_running).raw == 0x0000'0020);
static_assert(state::of(state::reversing_and_start).raw == 0x0000'0040);  // Reversing and start
static_assert(state::of(state::ramp_operation).raw == 0x0000'0080);  // Ramp operation
static_assert(state::of(state::reversing).raw == 0x0000'0100);  // Reversing
static_assert(state::of(state::speed_equals_reference).raw == 0x0000'0200);  // Speed = reference
static_assert(state::of(state::running).raw == 0x0000'0400);  // Running
static_assert(state::of(state::remote_controlled_reference).raw == 0x0000'0800);
static_assert(state::of(state::off_mode).raw == 0x0000'1000);  // OFF mode = 1
static_assert(state::of(state::hand_mode).raw == 0x0000'2000);  // Auto mode = 0, Hand mode = 1
static_assert(state::of(state::start_blocked).raw == 0x0000'4000);  // Start blocked
static_assert(state::of(state::start_blocked_signal_missing).raw == 0x0000'8000);  // Start blocked signal missing
static_assert(state::of(state::freeze_output).raw == 0x0001'0000);  // Freeze output
static_assert(state::of(state::freeze_output_blocked).raw == 0x0002'0000);  // Freeze output blocked
static_assert(state::of(state::jogging).raw == 0x0004'0000);  // Jogging
static_assert(state::of(state::jog_blocked).raw == 0x0008'0000);  // Jog blocked
static_assert(state::of(state::stand_by).raw == 0x0010'0000);  // Stand by
static_assert(state::of(state::stop).raw == 0x0020'0000);  // Stop
static_assert(state::of(state::dc_stop).raw == 0x0040'0000);  // DC stop
static_assert(state::of(state::drive_ready_23).raw == 0x0080'0000);  // Drive ready
static_assert(state::of(state::relay_123_active).raw == 0x0100'0000);  // Relay 123 active
static_assert(state::of(state::drive_ready_25).raw == 0x0200'0000);  // Drive ready
static_assert(state::of(state::control_ready).raw == 0x0400'0000);  // Control ready
static_assert(state::of(state::start_prevented).raw == 0x0800'0000);  // Start prevented
static_assert(state::of(state::profibus_off3_active).raw == 0x1000'0000);  // Profibus OFF3 active
static_assert(state::of(state::profibus_off2_active).raw == 0x2000'0000);  // Profibus OFF2 active
static_assert(state::of(state::profibus_off1_active).raw == 0x4000'0000);  // Profibus OFF1 active
static_assert(state::of(state::reserved_31).raw == 0x8000'0000);  // Reserved
// clang-format on

TEST(vlt6000_manual, says_drive_ready_of_two_bits_of_the_extended_status_word)
{
    constexpr auto one   = extended_status_word::from_raw(0x0080'0000);
    constexpr auto other = extended_status_word::from_raw(0x0200'0000);
    VERIFY(one.test(extended_status_word::drive_ready_23) and not one.test(extended_status_word::drive_ready_25));
    VERIFY(other.test(extended_status_word::drive_ready_25) and not other.test(extended_status_word::drive_ready_23));
}

TEST(vlt6000_manual, describes_the_extended_status_word_with_the_text_of_the_warning_word)
{
    // Two words with two tables: 00000020 is a state in one and an overcurrent in the other.
    VERIFY(not std::is_same_v<extended_status_word, warning_word>);
    VERIFY(extended_status_word::of(extended_status_word::automatic_motor_adaptation_running).raw
           == warning_word::of(warning_word::overcurrent).raw);
}

TEST(vlt6000_extended_status_word, has_two_bits_that_say_something_at_0_as_well)
{
    constexpr auto word = extended_status_word::from_raw(0x0000'3800);
    VERIFY(word.test(extended_status_word::remote_controlled_reference));
    VERIFY(word.test(extended_status_word::hand_mode) and word.test(extended_status_word::off_mode));
    VERIFY(not extended_status_word{}.test(extended_status_word::remote_controlled_reference));  // local reference
    VERIFY(not extended_status_word{}.test(extended_status_word::hand_mode));                    // auto mode
}

TEST(vlt6000_extended_status_word, keeps_every_bit_that_it_is_given)
{
    for (unsigned bit = 0; bit < 32; ++bit) {
        auto const alone  = std::uint32_t{1} << bit;
        auto const others = ~alone;
        EXPECT_EQ(extended_status_word::from_raw(alone).raw, alone);
        EXPECT_EQ(extended_status_word::from_raw(others).raw, others);
        EXPECT_EQ(extended_status_word::from_raw(alone).test(extended_status_word::stand_by), alone == 0x0010'0000U);
        EXPECT_EQ(extended_status_word::from_raw(others).with(extended_status_word::stand_by).raw,
                  others | 0x0010'0000U);
        EXPECT_EQ(extended_status_word::from_raw(others).without(extended_status_word::stand_by).raw,
                  others & ~0x0010'0000U);
    }
    VERIFY(extended_status_word::from_raw(0xFFFF'FFFFU).raw == 0xFFFF'FFFFU);
}

}  // namespace
