#include <drivecodec/cia402/controller.hpp>
#include <drivecodec/cia402/path.hpp>

#include "cia402/drive_in.hpp"
#include "support/verify.hpp"

#include <array>
#include <random>

namespace {

using namespace drivecodec::cia402;

constexpr status_word word_of(unsigned raw)
{
    return status_word::from_raw(static_cast<std::uint16_t>(raw));
}

constexpr unsigned switch_on_disabled = 0x0250;
constexpr unsigned ready              = 0x0231;
constexpr unsigned switched_on        = 0x0233;
constexpr unsigned operation_enabled  = 0x0237;
constexpr unsigned quick_stop_active  = 0x0217;
constexpr unsigned fault_reaction     = 0x023F;
constexpr unsigned fault              = 0x0238;
constexpr unsigned no_state           = 0x0202;

/// What the controller says to a statusword, and the word it then wants to be sent.
#define EXPECT_UPDATE(control, status, says, sends)                 \
    do {                                                            \
        EXPECT_EQ(control.update(word_of(status)), progress::says); \
        EXPECT_EQ(control.word().raw, sends);                       \
    } while (false)

TEST(controller, commands_nothing_before_it_has_heard_anything)
{
    controller control;
    VERIFY(controller{}.word().raw == 0x0000);
    VERIFY(controller{}.goal() == state::switch_on_disabled);
    control.set_goal(state::operation_enabled);
    EXPECT_EQ(control.word().raw, 0x0000);
}

TEST(controller, goes_6_7_F_and_back)
{
    controller control;
    control.set_goal(state::operation_enabled);
    EXPECT_UPDATE(control, switch_on_disabled, waiting, 0x0006);
    EXPECT_UPDATE(control, ready, waiting, 0x0007);
    EXPECT_UPDATE(control, switched_on, waiting, 0x000F);
    EXPECT_UPDATE(control, operation_enabled, reached, 0x000F);
    control.set_goal(state::switch_on_disabled);
    EXPECT_UPDATE(control, operation_enabled, waiting, 0x0000);
    EXPECT_UPDATE(control, switch_on_disabled, reached, 0x0000);
}

TEST(controller, keeps_halt_and_mode_bits_in_every_word)
{
    controller control;
    control.set_other_bits(control_word::from_raw(0xFFFF));
    control.set_goal(state::operation_enabled);
    EXPECT_UPDATE(control, switch_on_disabled, waiting, 0xFF76);
    EXPECT_UPDATE(control, ready, waiting, 0xFF77);
    EXPECT_UPDATE(control, switched_on, waiting, 0xFF7F);
    EXPECT_UPDATE(control, no_state, waiting, 0xFF7F);
    control.set_other_bits({});
    EXPECT_UPDATE(control, operation_enabled, reached, 0x000F);
}

TEST(controller, takes_over_a_drive_that_is_already_there)
{
    controller control;
    control.set_goal(state::operation_enabled);
    EXPECT_UPDATE(control, operation_enabled, reached, 0x000F);
}

TEST(controller, does_not_mind_a_state_that_was_skipped)
{
    controller control;
    control.set_goal(state::operation_enabled);
    EXPECT_UPDATE(control, switch_on_disabled, waiting, 0x0006);
    EXPECT_UPDATE(control, switched_on, waiting, 0x000F);
}

TEST(controller, resets_a_fault_by_one_edge_and_only_when_told_to)
{
    controller control;
    control.set_goal(state::operation_enabled);
    for (int i = 0; i < 50; ++i) { EXPECT_UPDATE(control, fault, faulted, 0x0000); }
    control.reset_fault();
    EXPECT_UPDATE(control, fault, waiting, 0x0000);  // low, whatever was sent before
    EXPECT_UPDATE(control, fault, waiting, 0x0080);  // the edge
    EXPECT_UPDATE(control, fault, waiting, 0x0000);  // never held
    EXPECT_UPDATE(control, switch_on_disabled, waiting, 0x0006);
    EXPECT_UPDATE(control, fault, faulted, 0x0000);  // leave was for one fault
}

TEST(controller, says_faulted_again_if_the_reset_did_not_help)
{
    controller control{{.patience = 3}};
    control.reset_fault();
    EXPECT_UPDATE(control, fault, waiting, 0x0000);
    EXPECT_UPDATE(control, fault, waiting, 0x0080);
    int words = 0;
    while (control.update(word_of(fault)) == progress::waiting) { ASSERT_LT(++words, 10); }
    EXPECT_UPDATE(control, fault, faulted, 0x0000);
}

TEST(controller, keeps_its_leave_to_reset_while_the_drive_reacts_to_the_fault)
{
    controller control;
    control.reset_fault();
    EXPECT_UPDATE(control, fault_reaction, waiting, 0x0000);
    EXPECT_UPDATE(control, fault, waiting, 0x0000);
    EXPECT_UPDATE(control, fault, waiting, 0x0080);
}

TEST(controller, forgets_its_leave_to_reset_where_there_is_no_fault)
{
    controller control;
    control.reset_fault();
    EXPECT_UPDATE(control, switch_on_disabled, reached, 0x0000);
    EXPECT_UPDATE(control, fault, faulted, 0x0000);
}

TEST(controller, says_refused_after_so_many_words_and_goes_on_asking)
{
    constexpr std::uint16_t patience = 5;
    controller              control{{.patience = patience}};
    control.set_goal(state::operation_enabled);
    EXPECT_UPDATE(control, switch_on_disabled, waiting, 0x0006);
    for (int i = 0; i < patience; ++i) { EXPECT_UPDATE(control, switch_on_disabled, waiting, 0x0006); }
    EXPECT_UPDATE(control, switch_on_disabled, refused, 0x0006);
    EXPECT_UPDATE(control, no_state, refused, 0x0006);
    EXPECT_UPDATE(control, ready, waiting, 0x0007);  // late, but it follows
}

TEST(controller, is_as_patient_as_it_is_told)
{
    for (auto const patience : {0U, 1U, 10U, 65535U}) {
        for (auto const first : {switch_on_disabled, no_state}) {
            controller control{{.patience = static_cast<std::uint16_t>(patience)}};
            control.set_goal(state::operation_enabled);
            auto const is_new = first == no_state ? 0U : 1U;
            for (unsigned i = 0; i < patience + is_new; ++i) {
                ASSERT_EQ(control.update(word_of(first)), progress::waiting) << patience << ' ' << i;
            }
            for (int i = 0; i < 3; ++i) { ASSERT_EQ(control.update(word_of(first)), progress::refused) << patience; }
        }
    }
}

TEST(controller, waits_for_ten_words_unless_told_otherwise)
{
    controller control;
    for (int i = 0; i < 10; ++i) { EXPECT_UPDATE(control, no_state, waiting, 0x0000); }
    EXPECT_UPDATE(control, no_state, refused, 0x0000);
}

TEST(controller, takes_any_first_state_for_a_sign_of_life)
{
    for (auto const status : {0x0210U, ready, switched_on, operation_enabled, quick_stop_active, fault_reaction}) {
        controller control{{.patience = 0}};
        EXPECT_EQ(control.update(word_of(status)), progress::waiting) << status;
        EXPECT_EQ(control.update(word_of(status)), progress::refused) << status;
    }
}

TEST(controller, says_refused_of_a_drive_that_stays_in_a_transient_state)
{
    for (auto const status : {0x0210U, fault_reaction}) {
        controller control{{.patience = 2}};
        control.set_goal(state::operation_enabled);
        for (int i = 0; i < 3; ++i) { EXPECT_UPDATE(control, status, waiting, 0x0000); }
        EXPECT_UPDATE(control, status, refused, 0x0000);
    }
}

/// The longest that a drive can keep it waiting: each state but the goal for as long as the patience lasts, and the
/// reset.
TEST(controller, never_waits_for_longer_than_it_says)
{
    for (unsigned patience = 0; patience < 5; ++patience) {
        controller control{{.patience = static_cast<std::uint16_t>(patience)}};
        control.set_goal(state::operation_enabled);
        control.reset_fault();
        unsigned   waited   = 0;
        auto const wait_for = [&](unsigned status, unsigned count) {
            for (unsigned i = 0; i < count; ++i) {
                ASSERT_EQ(control.update(word_of(status)), progress::waiting) << patience << ' ' << waited;
                ++waited;
            }
        };
        wait_for(no_state, patience);
        wait_for(fault_reaction, patience + 1);
        wait_for(fault, 2 + patience + 1);
        for (auto const status : {0x0210U, switch_on_disabled, ready, switched_on, quick_stop_active}) {
            wait_for(status, patience + 1);
        }
        EXPECT_EQ(control.update(word_of(no_state)), progress::refused);
        EXPECT_EQ(waited, 8 * (patience + 1) + 1);
    }
}

TEST(controller, says_refused_of_a_drive_that_runs_in_circles)
{
    controller control{{.patience = 5}};
    control.set_goal(state::operation_enabled);
    int words = 0;
    while (control.update(word_of(words % 2 == 0 ? switch_on_disabled : ready)) != progress::refused) {
        ASSERT_LT(++words, 20);
    }
}

TEST(controller, says_unreachable_and_leaves_the_drive_alone)
{
    controller control;
    control.set_goal(state::quick_stop_active);
    EXPECT_UPDATE(control, switched_on, unreachable, 0x0007);
    EXPECT_UPDATE(control, operation_enabled, waiting, 0x0002);
    EXPECT_UPDATE(control, quick_stop_active, reached, 0x0002);
    control.set_goal(state::fault);
    EXPECT_UPDATE(control, quick_stop_active, unreachable, 0x0002);
}

TEST(controller, does_not_go_on_with_an_earlier_command_where_the_goal_is_unreachable)
{
    controller control;
    control.set_goal(state::operation_enabled);
    EXPECT_UPDATE(control, switched_on, waiting, 0x000F);
    control.set_goal(state::quick_stop_active);
    EXPECT_UPDATE(control, switched_on, unreachable, 0x0007);
    EXPECT_UPDATE(control, ready, unreachable, 0x0006);
    EXPECT_UPDATE(control, switch_on_disabled, unreachable, 0x0000);
}

TEST(controller, does_not_enable_operation_once_that_is_no_longer_the_goal)
{
    constexpr std::array<unsigned, 5> words{0x0000, 0x0006, 0x0007, 0x000F, 0x0002};  // by goal
    for (unsigned g = 1; g <= 5; ++g) {
        controller control;
        control.set_other_bits(control_word::from_raw(0x0100));
        control.set_goal(state::operation_enabled);
        EXPECT_UPDATE(control, switched_on, waiting, 0x010F);  // and is lost
        control.set_goal(static_cast<state>(g));
        EXPECT_EQ(control.word().raw, 0x0100 | words[g - 1]) << g;
        EXPECT_UPDATE(control, no_state, waiting, (0x0100 | words[g - 1]));
    }
}

TEST(controller, commands_nothing_by_a_goal_alone)
{
    for (unsigned g = 0; g < state_count; ++g) {
        controller control;
        control.set_goal(static_cast<state>(g));
        EXPECT_EQ(control.word().raw, 0x0000) << g;
        EXPECT_UPDATE(control, no_state, waiting, 0x0000);
    }
}

TEST(controller, says_unreachable_once_the_drive_has_left_quick_stop_by_itself)
{
    controller control;
    control.set_goal(state::quick_stop_active);
    EXPECT_UPDATE(control, operation_enabled, waiting, 0x0002);
    EXPECT_UPDATE(control, quick_stop_active, reached, 0x0002);
    EXPECT_UPDATE(control, switch_on_disabled, unreachable, 0x0000);
}

//=== with a drive ===//

/// What a drive does by itself in this state, at once.
void go_on(machine& drive)
{
    if (drive.state() == state::not_ready_to_switch_on) { drive.initialised(); }
    if (drive.state() == state::fault_reaction_active) { drive.fault_handled(); }
}

constexpr std::array all_ways{way{false, false}, way{true, false}, way{false, true}, way{true, true}};

TEST(controller, reaches_every_goal_from_every_state_in_as_many_words_as_the_path_has_transitions)
{
    for (auto const chosen : all_ways) {
        for (unsigned s = 0; s < state_count; ++s) {
            for (unsigned g = 0; g < state_count; ++g) {
                auto const from  = static_cast<state>(s);
                auto const goal  = static_cast<state>(g);
                auto const whole = path::between(from, goal, chosen);
                auto       drive = drive_in(from, {.resumes_from_quick_stop = chosen.resumes_from_quick_stop});
                controller control{{.way = chosen}};
                control.set_goal(goal);
                control.reset_fault();

                std::size_t words = 0;
                auto        says  = control.update(drive.status());
                while (says == progress::waiting) {
                    ASSERT_LT(++words, 20U) << s << ' ' << g;
                    drive.receive(control.word());
                    go_on(drive);
                    says = control.update(drive.status());
                }
                EXPECT_EQ(says, whole ? progress::reached : progress::unreachable) << s << ' ' << g;
                if (not whole) { continue; }
                EXPECT_EQ(drive.state(), goal) << s << ' ' << g;
                // The reset takes a word to lower its bit; 000Fh is one word for two transitions.
                auto expected = whole->size();
                for (auto const& row : *whole) {
                    if (row.number == 15) { ++expected; }
                    if (row.number == 3 and row.cause == cause{command::enable_operation}) { --expected; }
                }
                EXPECT_EQ(words, expected) << s << ' ' << g;
            }
        }
    }
}

/// Up to Operation enabled and down again. One thing goes wrong at one step; the rest of the way is quiet.
TEST(controller, gets_over_whatever_goes_wrong_at_any_one_step)
{
    enum class trouble {
        lost_reply,
        repeated_reply,
        lost_command,
        repeated_command,
        reply_of_no_state,
        a_fault,
        voltage_lost,
    };
    for (int t = 0; t <= static_cast<int>(trouble::voltage_lost); ++t) {
        auto const which = static_cast<trouble>(t);
        for (int bad_step = 0; bad_step < 12; ++bad_step) {
            machine    drive;
            controller control;
            auto       last       = drive.status();
            auto       had_faults = 0;
            int        step       = 0;
            for (auto const goal : {state::operation_enabled, state::switch_on_disabled}) {
                control.set_goal(goal);
                auto says = progress::waiting;
                for (int i = 0; says != progress::reached; ++i, ++step) {
                    ASSERT_LT(i, 12) << t << ' ' << bad_step;
                    auto const is_bad = step == bad_step;
                    go_on(drive);
                    if (is_bad and which == trouble::a_fault) { drive.fault(); }
                    if (is_bad and which == trouble::voltage_lost) { drive.voltage_lost(); }
                    if (not is_bad) { drive.voltage_restored(); }

                    auto const now = drive.status();
                    if (is_bad and which == trouble::reply_of_no_state) {
                        says = control.update(word_of(no_state));
                    } else if (is_bad and which == trouble::repeated_reply) {
                        says = control.update(last);
                    } else if (not is_bad or which != trouble::lost_reply) {
                        says = control.update(now);
                    }
                    last = now;
                    if (says == progress::faulted) {
                        ++had_faults;
                        control.reset_fault();
                    }
                    if (not is_bad or which != trouble::lost_command) { drive.receive(control.word()); }
                    if (is_bad and which == trouble::repeated_command) { drive.receive(control.word()); }
                    ASSERT_TRUE(says != progress::refused and says != progress::unreachable) << t << ' ' << bad_step;
                }
            }
            go_on(drive);
            EXPECT_LE(had_faults, which == trouble::a_fault ? 1 : 0) << t << ' ' << bad_step;
        }
    }
}

TEST(controller, starts_again_when_the_voltage_is_back)
{
    auto       drive = drive_in(state::operation_enabled);
    controller control;
    control.set_goal(state::operation_enabled);
    EXPECT_EQ(control.update(drive.status()), progress::reached);
    drive.voltage_lost();
    auto says = progress::waiting;
    for (int i = 0; i < 20; ++i) {
        says = control.update(drive.status());
        drive.receive(control.word());
    }
    EXPECT_EQ(says, progress::refused);
    EXPECT_EQ(drive.state(), state::ready_to_switch_on);  // without voltage no further
    drive.voltage_restored();
    for (int i = 0; i < 3; ++i) {
        drive.receive(control.word());
        says = control.update(drive.status());
    }
    EXPECT_EQ(says, progress::reached);
}

/// A drive and its controller over a line that loses words both ways and repeats some, with events at any time.
TEST(controller, reaches_or_reports_in_ten_thousand_random_schedules)
{
    constexpr std::array goals{state::switch_on_disabled, state::ready_to_switch_on, state::switched_on,
                               state::operation_enabled, state::quick_stop_active};
    constexpr int        stormy = 60;
    constexpr int        calm   = 60;
    std::mt19937         random{402};  // NOLINT: the same schedules every time
    auto const           one_in = [&](unsigned n) { return random() % n == 0; };

    int reached          = 0;
    int could_be_reached = 0;
    for (int schedule = 0; schedule < 10'000; ++schedule) {
        auto const resumes  = one_in(2);
        auto const straight = one_in(2);
        machine    drive{{.stays_in_quick_stop = one_in(2) or resumes, .resumes_from_quick_stop = resumes}};
        controller control{{.way = {.resumes_from_quick_stop = resumes, .straight_to_operation_enabled = straight}}};
        auto const others = control_word::from_raw(static_cast<std::uint16_t>(random() & 0xFF70U));
        control.set_other_bits(others);
        control.set_goal(goals[random() % goals.size()]);

        auto heard     = drive.status();
        auto had_edge  = false;
        auto may_reset = false;
        auto says      = progress::waiting;
        for (int i = 0; i < stormy + calm; ++i) {
            auto const is_stormy = i < stormy;
            if (drive.state() == state::not_ready_to_switch_on and one_in(3)) { drive.initialised(); }
            if (drive.state() == state::fault_reaction_active and one_in(3)) { drive.fault_handled(); }
            if (drive.state() == state::quick_stop_active and one_in(3)) { drive.quick_stop_finished(); }
            if (is_stormy) {
                if (one_in(20)) { drive.fault(); }
                if (one_in(20)) { drive.voltage_lost(); }
                if (one_in(20)) { control.set_goal(goals[random() % goals.size()]); }
                if (one_in(20)) { drive.receive(control_word::from_raw(0x0002)); }  // someone else's quick stop
            } else if (i == stormy) {
                control.set_goal(control.goal());  // a refusal of the storm is past
            }
            if (one_in(3)) { drive.voltage_restored(); }
            if (says == progress::faulted and one_in(2)) {
                control.reset_fault();
                may_reset = true;
            }

            auto const lost = is_stormy and one_in(4);
            if (not lost) { heard = drive.status(); }  // else the reply before, once more
            if (is_stormy and one_in(10)) { heard = word_of(random() & 0xFFFFU); }
            says = control.update(heard);

            auto const sent = control.word();
            ASSERT_TRUE(not sent.test(control_word::enable_operation) or control.goal() == state::operation_enabled)
                << "the motor would get power on the way to another goal";
            ASSERT_EQ(sent.raw & 0xFF70, others.raw);
            if (sent.test(control_word::fault_reset)) {
                ASSERT_FALSE(had_edge) << "the reset bit was held";
                ASSERT_TRUE(may_reset) << "nobody asked for a reset";
                ASSERT_EQ(sent.raw & 0x000F, 0) << "the reset must not switch anything on";
            }
            had_edge = sent.test(control_word::fault_reset);
            if (not(is_stormy and one_in(4))) { drive.receive(sent); }
        }
        auto const is_quick_stop = control.goal() == state::quick_stop_active;
        ASSERT_TRUE(says == progress::reached or says == progress::refused or says == progress::faulted
                    or (is_quick_stop and says == progress::unreachable))
            << "schedule " << schedule << ", goal " << static_cast<int>(control.goal()) << ", state "
            << static_cast<int>(drive.state()) << ", says " << static_cast<int>(says);
        could_be_reached += is_quick_stop ? 0 : 1;
        reached += says == progress::reached and not is_quick_stop ? 1 : 0;
        if (says == progress::reached) { ASSERT_EQ(drive.state(), control.goal()); }
    }
    EXPECT_GT(reached, could_be_reached * 99 / 100);  // on a quiet line there is hardly a reason not to
}

}  // namespace
