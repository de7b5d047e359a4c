#include <drivecodec/drives/vlt6000/control_word.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::vlt6000;

constexpr control_word word_of(unsigned raw)
{
    return control_word::from_raw(static_cast<std::uint16_t>(raw));
}

// VLT 6000 manual, "Control word as per FC protocol": each bit.
static_assert(control_word{}.with(control_word::preset_reference, preset_reference::preset_reference_2).raw == 0x0001);
static_assert(control_word{}.with(control_word::preset_reference, preset_reference::preset_reference_3).raw == 0x0002);
static_assert(control_word::of(control_word::no_dc_brake).raw == 0x0004);
static_assert(control_word::of(control_word::no_coasting_stop).raw == 0x0008);
static_assert(control_word::of(control_word::no_quick_stop).raw == 0x0010);
static_assert(control_word::of(control_word::no_freeze_output).raw == 0x0020);
static_assert(control_word::of(control_word::start).raw == 0x0040);
static_assert(control_word::of(control_word::reset).raw == 0x0080);
static_assert(control_word::of(control_word::jog).raw == 0x0100);
static_assert(control_word::of(control_word::no_function_9).raw == 0x0200);
static_assert(control_word::of(control_word::data_valid).raw == 0x0400);
static_assert(control_word::of(control_word::relay_1).raw == 0x0800);
static_assert(control_word::of(control_word::relay_2).raw == 0x1000);
static_assert(control_word{}.with(control_word::setup, setup::setup_2).raw == 0x2000);
static_assert(control_word{}.with(control_word::setup, setup::setup_3).raw == 0x4000);
static_assert(control_word::of(control_word::reversing).raw == 0x8000);

TEST(vlt6000_control_word, chooses_the_preset_reference_of_the_manual_s_table)
{
    VERIFY(number(word_of(0b00).get(control_word::preset_reference)) == 1);
    VERIFY(number(word_of(0b01).get(control_word::preset_reference)) == 2);
    VERIFY(number(word_of(0b10).get(control_word::preset_reference)) == 3);
    VERIFY(number(word_of(0b11).get(control_word::preset_reference)) == 4);
}

TEST(vlt6000_control_word, chooses_the_setup_of_the_manual_s_table)
{
    VERIFY(number(word_of(0x0000).get(control_word::setup)) == 1);
    VERIFY(number(word_of(0x2000).get(control_word::setup)) == 2);
    VERIFY(number(word_of(0x4000).get(control_word::setup)) == 3);
    VERIFY(number(word_of(0x6000).get(control_word::setup)) == 4);
}

TEST(vlt6000_manual, starts_with_a_word_that_selects_preset_reference_4)
{
    constexpr auto start_command = word_of(0x047F);
    VERIFY(start_command.get(control_word::preset_reference) == preset_reference::preset_reference_4);
    VERIFY(start_command.get(control_word::setup) == setup::setup_1);
    VERIFY(start_command.without(control_word::start).raw == 0x043F);
}

TEST(vlt6000_manual, explains_a_0_in_bit_06_under_the_name_of_bit_04)
{
    // Two bits, two stops: ramp stop is bit 06, quick stop is bit 04.
    VERIFY(not word_of(0x043F).test(control_word::start) and word_of(0x043F).test(control_word::no_quick_stop));
    VERIFY(word_of(0x046F).test(control_word::start) and not word_of(0x046F).test(control_word::no_quick_stop));
}

TEST(vlt6000_control_word, keeps_every_bit_that_it_is_given)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = word_of(raw);
        ASSERT_EQ(word.raw, raw);
        ASSERT_EQ(word.with(control_word::no_function_9).without(control_word::no_function_9).raw, raw & ~0x0200U);
        ASSERT_EQ(static_cast<unsigned>(word.get(control_word::preset_reference)), raw & 3U);
        ASSERT_EQ(static_cast<unsigned>(word.get(control_word::setup)), raw >> 13 & 3U);
        for (unsigned choice = 0; choice < 4; ++choice) {
            ASSERT_EQ(
                word.with(control_word::preset_reference, preset_reference{static_cast<std::uint8_t>(choice)}).raw,
                (raw & ~0x0003U) | choice);
            ASSERT_EQ(word.with(control_word::setup, setup{static_cast<std::uint8_t>(choice)}).raw,
                      (raw & ~0x6000U) | choice << 13);
        }
    }
}

}  // namespace
