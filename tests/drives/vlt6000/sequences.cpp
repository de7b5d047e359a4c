#include <drivecodec/drives/vlt6000/sequences.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec::vlt6000;

constexpr control_word word_of(unsigned raw)
{
    return control_word::from_raw(static_cast<std::uint16_t>(raw));
}

//=== the manual's words ===//

TEST(vlt6000_sequences, have_the_manual_s_start_command)
{
    VERIFY(start_command.raw == 0x047F);
    VERIFY(select(start(neutral), preset_reference::preset_reference_4) == start_command);
    VERIFY(start(start_command) == start_command);
}

TEST(vlt6000_manual, starts_with_preset_reference_4_where_a_start_alone_has_1)
{
    VERIFY(start_command.get(control_word::preset_reference) == preset_reference::preset_reference_4);
    VERIFY(start(neutral).raw == 0x047C);
    VERIFY(start(neutral).get(control_word::preset_reference) == preset_reference::preset_reference_1);
}

TEST(vlt6000_sequences, begin_from_a_word_that_stops_and_does_nothing_else)
{
    VERIFY(neutral.raw == 0x043C);
    VERIFY(stop(neutral) == neutral and end_jog(neutral) == neutral and release_output(neutral) == neutral);
    VERIFY(prepare_reset(neutral) == neutral and end_reverse(neutral) == neutral);
    VERIFY(select(neutral, setup::setup_1) == neutral);
}

TEST(vlt6000_sequences, make_the_words_of_the_manual_s_bits)
{
    VERIFY(stop(start_command).raw == 0x043F);
    VERIFY(quick_stop(start_command).raw == 0x046F);
    VERIFY(coast(start_command).raw == 0x0477);
    VERIFY(dc_brake(start_command).raw == 0x047B);
    VERIFY(freeze_output(start_command).raw == 0x045F);
    VERIFY(jog(start_command).raw == 0x057F);
    VERIFY(reset(neutral).raw == 0x04BC);
    VERIFY(reverse(start_command).raw == 0x847F);
    VERIFY(select(start_command, preset_reference::preset_reference_2).raw == 0x047D);
    VERIFY(select(start_command, setup::setup_4).raw == 0x647F);
}

//=== every word ===//

struct sequence {
    control_word (*function)(control_word) noexcept;
    unsigned sets;
    unsigned clears;
};
// The manual's bits, and bit 10 in each.
constexpr std::array sequences{
    sequence{start, 0x047C, 0x0000},   sequence{stop, 0x0420, 0x0140},          sequence{quick_stop, 0x0420, 0x0110},
    sequence{coast, 0x0400, 0x0008},   sequence{dc_brake, 0x0400, 0x0004},      sequence{jog, 0x0500, 0x0000},
    sequence{end_jog, 0x0400, 0x0100}, sequence{freeze_output, 0x0400, 0x0020}, sequence{release_output, 0x0420, 0x000},
    sequence{reverse, 0x8400, 0x0000}, sequence{end_reverse, 0x0400, 0x8000},   sequence{prepare_reset, 0x0400, 0x0080},
    sequence{reset, 0x0480, 0x0000},
};

TEST(vlt6000_sequences, keep_all_bits_that_they_do_not_own_and_are_always_valid)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        for (auto const& each : sequences) {
            auto const given = each.function(word_of(raw));
            ASSERT_EQ(given.raw, (raw | each.sets) & ~each.clears) << raw;
            ASSERT_TRUE(given.test(control_word::data_valid));
            ASSERT_EQ(each.function(given), given);
        }
    }
}

TEST(vlt6000_sequences, select_without_touching_another_bit)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        for (std::uint8_t choice = 0; choice < 4; ++choice) {
            ASSERT_EQ(select(word_of(raw), preset_reference{choice}).raw, (raw & ~0x0003U) | 0x0400U | choice);
            ASSERT_EQ(select(word_of(raw), setup{choice}).raw, (raw & ~0x6000U) | 0x0400U | unsigned{choice} << 13);
        }
    }
}

TEST(vlt6000_sequences, start_whatever_stopped)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word    = word_of(raw);
        auto const running = start(word);
        ASSERT_EQ(start(coast(word)), running);
        ASSERT_EQ(start(dc_brake(word)), running);
        ASSERT_EQ(start(quick_stop(word)), end_jog(running));
        ASSERT_EQ(start(freeze_output(word)), running);
        ASSERT_EQ(start(stop(word)), end_jog(running));
    }
}

//=== a frozen output ===//

TEST(vlt6000_manual, says_that_bit_06_does_not_stop_a_frozen_output_so_stop_releases_it)
{
    constexpr auto frozen = freeze_output(start_command);
    VERIFY(not frozen.test(control_word::no_freeze_output) and frozen.test(control_word::start));
    VERIFY(frozen.without(control_word::start).raw == 0x041F);  // bit 06 alone: goes on

    VERIFY(stop(frozen).test(control_word::no_freeze_output) and not stop(frozen).test(control_word::start));
    VERIFY(quick_stop(frozen).test(control_word::no_freeze_output));  // quick stop is not among the ways out, either
    VERIFY(start(frozen) == start_command);
}

TEST(vlt6000_sequences, stop_a_frozen_output_in_the_manual_s_ways_without_releasing_it)
{
    constexpr auto frozen = freeze_output(start_command);
    VERIFY(coast(frozen).raw == 0x0457 and not coast(frozen).test(control_word::no_freeze_output));
    VERIFY(dc_brake(frozen).raw == 0x045B and not dc_brake(frozen).test(control_word::no_freeze_output));
}

TEST(vlt6000_sequences, stop_no_matter_what_went_before)
{
    // Neither start nor jog nor a frozen output is left, whatever the word was; of a quick stop only the start.
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const stopped = stop(word_of(raw));
        ASSERT_FALSE(stopped.test(control_word::start) or stopped.test(control_word::jog));
        ASSERT_TRUE(stopped.test(control_word::no_freeze_output));

        auto const quickly = quick_stop(word_of(raw));
        ASSERT_FALSE(quickly.test(control_word::no_quick_stop) or quickly.test(control_word::jog));
        ASSERT_TRUE(quickly.test(control_word::no_freeze_output));
    }
}

TEST(vlt6000_manual, ramps_by_207_in_quick_stop_and_in_ramp_stop_but_has_a_bit_for_each)
{
    VERIFY(quick_stop(start_command).test(control_word::start));
    VERIFY(stop(start_command).test(control_word::no_quick_stop));
    VERIFY(quick_stop(start_command) != stop(start_command));
}

//=== reset ===//

TEST(vlt6000_sequences, reset_by_a_rising_edge_in_every_word)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const first  = prepare_reset(word_of(raw));
        auto const second = reset(first);
        ASSERT_FALSE(first.test(control_word::reset));
        ASSERT_EQ(second.raw, first.raw | 0x0080U);
        ASSERT_EQ(reset(second), second);  // sent again it is no edge
        ASSERT_EQ(prepare_reset(second), first);
    }
}

TEST(vlt6000_sequences, reset_without_a_start)
{
    VERIFY(not reset(stop(start_command)).test(control_word::start));
    VERIFY(reset(start_command).test(control_word::start));  // the caller's choice
}

}  // namespace
