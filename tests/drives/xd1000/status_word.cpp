#include <drivecodec/cia402/next.hpp>
#include <drivecodec/drives/xd1000/status_word.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec::xd1000;
using drivecodec::cia402::state;

constexpr status_word word_of(unsigned raw)
{
    return status_word::from_raw(static_cast<std::uint16_t>(raw));
}

// xD1000 manual, "Status word description ETA - 3201": each bit.
static_assert(status_word::of(status_word::ready_to_switch_on).raw == 0x0001);
static_assert(status_word::of(status_word::switched_on).raw == 0x0002);
static_assert(status_word::of(status_word::operation_enabled).raw == 0x0004);
static_assert(status_word::of(status_word::fault).raw == 0x0008);
static_assert(status_word::of(status_word::voltage_enabled).raw == 0x0010);
static_assert(status_word::of(status_word::no_quick_stop).raw == 0x0020);
static_assert(status_word::of(status_word::switch_on_disabled).raw == 0x0040);
static_assert(status_word::of(status_word::remote).raw == 0x0200);
static_assert(status_word::of(status_word::reference_reached).raw == 0x0400);
static_assert(status_word::of(status_word::reference_exceeded).raw == 0x0800);
static_assert(status_word::of(status_word::stopped_by_stop_key).raw == 0x4000);
static_assert(status_word{}.with(status_word::direction, direction::reverse).raw == 0x8000);

struct printed_row {
    unsigned value;
    state    means;
};
constexpr std::array printed{printed_row{0x0050, state::switch_on_disabled},
                             printed_row{0x0031, state::ready_to_switch_on},
                             printed_row{0x0033, state::switched_on},
                             printed_row{0x0037, state::operation_enabled},
                             printed_row{0x0017, state::quick_stop_active},
                             printed_row{0x0018, state::fault},
                             printed_row{0x0038, state::fault}};

TEST(xd1000_manual, prints_values_as_eta_masked_by_006F_that_this_mask_cannot_give)
{
    for (auto const& row : printed) {
        EXPECT_NE(row.value & 0x006FU, row.value);                         // none of them can be compared with
        EXPECT_EQ(*decode_state(word_of(row.value)), row.means);           // as they stand they decode
        EXPECT_EQ(*decode_state(word_of(row.value & 0x006F)), row.means);  // and masked, too
    }
}

TEST(xd1000_manual, has_no_value_for_two_states_and_two_for_fault)
{
    VERIFY(*decode_state(word_of(0x0010)) == state::not_ready_to_switch_on);
    VERIFY(*decode_state(word_of(0x003F)) == state::fault_reaction_active);
    VERIFY(*decode_state(word_of(0x001F)) == state::fault_reaction_active);
    VERIFY(*decode_state(word_of(0x0018)) == state::fault);  // after a quick stop
    VERIFY(*decode_state(word_of(0x0038)) == state::fault);
}

TEST(xd1000_manual, says_bit_4_is_always_1_and_bit_7_always_0_but_neither_decides_the_state)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        ASSERT_EQ(decode_state(word_of(raw)), decode_state(word_of(raw ^ 0x0090U))) << raw;
    }
}

TEST(xd1000_manual, calls_bit_9_local_mode_active_at_0)
{
    VERIFY(word_of(0x0000).is_local() and not word_of(0x0200).is_local());
}

TEST(xd1000_manual, says_once_that_a_setting_leads_back_from_two_states_and_once_from_one)
{
    // So it may happen in both: the next command follows from the state that ETA reports, not from the last command.
    using drivecodec::cia402::command;
    using drivecodec::cia402::next;
    constexpr auto fallen_back = *decode_state(word_of(0x0250));
    VERIFY(next(fallen_back, state::switched_on).command() == command::shutdown);
    VERIFY(next(fallen_back, state::operation_enabled).command() == command::shutdown);
}

TEST(xd1000_manual, says_that_operation_enabled_has_power_except_at_zero_reference_and_halt)
{
    // One and the same state with and without: what tells them apart is not in ETA.
    VERIFY(*decode_state(word_of(0x0637)) == *decode_state(word_of(0x0237)));
}

TEST(xd1000_status_word, has_the_state_of_the_standard_for_every_word)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        ASSERT_EQ(decode_state(word_of(raw)), drivecodec::cia402::decode_state(word_of(raw).standard()));
        ASSERT_EQ(status_word{word_of(raw).standard()}.raw, raw);
    }
}

}  // namespace
