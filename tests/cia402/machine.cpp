#include <drivecodec/cia402/machine.hpp>

#include "cia402/drive_in.hpp"
#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec::cia402;

constexpr control_word word_of(unsigned raw)
{
    return control_word::from_raw(static_cast<std::uint16_t>(raw));
}

constexpr auto not_ready = state::not_ready_to_switch_on;
constexpr auto disabled  = state::switch_on_disabled;
constexpr auto ready     = state::ready_to_switch_on;
constexpr auto on        = state::switched_on;
constexpr auto enabled   = state::operation_enabled;
constexpr auto quick     = state::quick_stop_active;
constexpr auto reaction  = state::fault_reaction_active;
constexpr auto faulty    = state::fault;

/// Where a low nibble leads, written from the standard's figure; the reset bit apart.
constexpr state after(state from, unsigned raw, bool resumes)
{
    auto const disable_voltage = (raw & 0x02U) == 0;
    auto const quick_stop      = not disable_voltage and (raw & 0x04U) == 0;
    auto const shutdown        = (raw & 0x07U) == 0x06;
    auto const enable          = (raw & 0x0FU) == 0x0F;
    switch (from) {
    case disabled: return shutdown ? ready : disabled;
    case ready: return disable_voltage or quick_stop ? disabled : shutdown ? ready : enable ? enabled : on;
    case on: return disable_voltage or quick_stop ? disabled : shutdown ? ready : enable ? enabled : on;
    case enabled: return disable_voltage ? disabled : quick_stop ? quick : shutdown ? ready : enable ? enabled : on;
    case quick: return disable_voltage ? disabled : enable and resumes ? enabled : quick;
    default: return from;
    }
}

TEST(machine, follows_the_standard_for_every_state_and_word)
{
    for (auto const resumes : {false, true}) {
        for (unsigned s = 0; s < state_count; ++s) {
            auto const from = static_cast<state>(s);
            for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
                auto drive = drive_in(from, {.stays_in_quick_stop = true, .resumes_from_quick_stop = resumes});
                ASSERT_EQ(drive.state(), from);
                drive.receive(word_of(raw));
                auto const wanted = from == faulty and (raw & 0x80U) != 0 ? disabled : after(from, raw, resumes);
                ASSERT_EQ(drive.state(), wanted) << s << ' ' << raw;
            }
        }
    }
}

TEST(machine, resets_a_fault_on_the_edge_only)
{
    auto drive = drive_in(faulty);
    drive.receive(word_of(0x0080));
    EXPECT_EQ(drive.state(), disabled);

    drive.fault();
    drive.fault_handled();
    for (int i = 0; i < 5; ++i) {
        drive.receive(word_of(0x0080));  // never low in between
        EXPECT_EQ(drive.state(), faulty);
    }
    drive.receive(word_of(0x0000));
    EXPECT_EQ(drive.state(), faulty);
    drive.receive(word_of(0x0080));
    EXPECT_EQ(drive.state(), disabled);
}

TEST(machine, does_not_reset_while_it_still_reacts)
{
    auto drive = drive_in(reaction);
    drive.receive(word_of(0x0080));
    EXPECT_EQ(drive.state(), reaction);
    drive.fault_handled();
    drive.receive(word_of(0x0080));  // the edge was before
    EXPECT_EQ(drive.state(), faulty);
}

TEST(machine, stays_in_quick_stop_or_leaves_it_as_the_option_code_says)
{
    auto stays = drive_in(quick, {.stays_in_quick_stop = true});
    stays.quick_stop_finished();
    EXPECT_EQ(stays.state(), quick);

    auto leaves = drive_in(quick, {.stays_in_quick_stop = false});
    leaves.quick_stop_finished();
    EXPECT_EQ(leaves.state(), disabled);
}

TEST(machine, stays_in_quick_stop_and_does_not_resume_unless_told_otherwise)
{
    auto drive = drive_in(quick);
    drive.quick_stop_finished();
    drive.receive(word_of(0x000F));
    EXPECT_EQ(drive.state(), quick);
}

TEST(machine, resumes_from_quick_stop_only_where_it_stays_there)
{
    auto drive = drive_in(quick, {.stays_in_quick_stop = false, .resumes_from_quick_stop = true});
    drive.receive(word_of(0x000F));
    EXPECT_EQ(drive.state(), quick);
}

TEST(machine, events_lead_nowhere_from_the_wrong_states)
{
    for (unsigned s = 0; s < state_count; ++s) {
        auto const from  = static_cast<state>(s);
        auto       drive = drive_in(from);
        drive.initialised();
        EXPECT_EQ(drive.state(), from == not_ready ? disabled : from);
        drive = drive_in(from);
        drive.fault_handled();
        EXPECT_EQ(drive.state(), from == reaction ? faulty : from);
        drive = drive_in(from);
        drive.fault();
        EXPECT_EQ(drive.state(), from == faulty ? faulty : reaction);
    }
}

TEST(machine, without_voltage_is_not_switched_on)
{
    for (unsigned s = 0; s < state_count; ++s) {
        auto const from     = static_cast<state>(s);
        auto       drive    = drive_in(from);
        auto const needs_it = from == on or from == enabled or from == quick;
        drive.voltage_lost();
        EXPECT_EQ(drive.state(), needs_it ? disabled : from) << s;
        EXPECT_FALSE(drive.status().test(status_word::voltage_enabled));
    }
    auto drive = drive_in(ready);
    drive.voltage_lost();
    drive.receive(word_of(0x0007));
    EXPECT_EQ(drive.state(), ready);
    drive.voltage_restored();
    drive.receive(word_of(0x0007));
    EXPECT_EQ(drive.state(), on);
}

TEST(machine, says_its_state_in_every_statusword)
{
    for (unsigned s = 0; s < state_count; ++s) {
        auto const from = static_cast<state>(s);
        EXPECT_EQ(*decode_state(drive_in(from).status()), from);
    }
}

TEST(machine, says_what_the_xd1000_s_manual_prints)
{
    VERIFY(drive_in(disabled).status().raw == 0x0050);
    VERIFY(drive_in(ready).status().raw == 0x0031);
    VERIFY(drive_in(on).status().raw == 0x0033);
    VERIFY(drive_in(enabled).status().raw == 0x0037);
    VERIFY(drive_in(quick).status().raw == 0x0017);
    VERIFY(drive_in(faulty).status().raw == 0x0038);

    constexpr auto after_quick_stop = [] {
        auto drive = drive_in(quick);
        drive.fault();
        drive.fault_handled();
        return drive.status();
    }();
    VERIFY(after_quick_stop.raw == 0x0018);
}

}  // namespace
