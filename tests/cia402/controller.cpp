#include <drivecodec/cia402/controller.hpp>
#include <drivecodec/cia402/machine.hpp>

#include "support/verify.hpp"

#include <array>
#include <random>

namespace {

using namespace drivecodec::cia402;

constexpr status_word word_of(unsigned raw) { return status_word::from_raw(static_cast<std::uint16_t>(raw)); }

constexpr unsigned switch_on_disabled = 0x0250;
constexpr unsigned ready              = 0x0231;
constexpr unsigned switched_on        = 0x0233;
constexpr unsigned operation_enabled  = 0x0237;
constexpr unsigned quick_stop_active  = 0x0217;
constexpr unsigned fault_reaction     = 0x023F;
constexpr unsigned fault              = 0x0238;
constexpr unsigned no_state           = 0x0202;

/// What the controller says to a statusword, and the word it then wants to be sent.
#define EXPECT_UPDATE(control, status, says, sends)   \
    do {                                              \
        EXPECT_EQ(control.update(word_of(status)), progress::says); \
        EXPECT_EQ(control.word().raw, sends);         \
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

/// A drive and its controller over a line that loses words both ways and repeats some, with events at any time.
TEST(controller, reaches_or_reports_in_ten_thousand_random_schedules)
{
    constexpr std::array goals{state::switch_on_disabled, state::ready_to_switch_on, state::switched_on,
                               state::operation_enabled};
    constexpr int        stormy = 60;
    constexpr int        calm   = 60;
    std::mt19937         random{402};  // NOLINT: the same schedules every time
    auto const           one_in = [&](unsigned n) { return random() % n == 0; };

    int reached = 0;
    for (int schedule = 0; schedule < 10'000; ++schedule) {
        auto const resumes = one_in(2);
        auto const straight = one_in(2);
        machine    drive{{.stays_in_quick_stop = one_in(2) or resumes, .resumes_from_quick_stop = resumes}};
        controller control{{.way = {.resumes_from_quick_stop = resumes, .straight_to_operation_enabled = straight}}};
        auto const others = control_word::from_raw(static_cast<std::uint16_t>(random() & 0xFF70U));
        control.set_other_bits(others);
        control.set_goal(goals[random() % goals.size()]);

        auto heard    = drive.status();
        auto had_edge = false;
        auto may_reset = false;
        auto says     = progress::waiting;
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
            auto const before = drive.state();
            says              = control.update(heard);

            auto const sent = control.word();
            ASSERT_EQ(sent.raw & 0xFF70, others.raw);
            if (sent.test(control_word::fault_reset)) {
                ASSERT_FALSE(had_edge) << "the reset bit was held";
                ASSERT_TRUE(may_reset) << "nobody asked for a reset";
                ASSERT_EQ(sent.raw & 0x000F, 0) << "the reset must not switch anything on";
            }
            had_edge = sent.test(control_word::fault_reset);
            if (not(is_stormy and one_in(4))) { drive.receive(sent); }

            if (not is_stormy and before != state::operation_enabled and drive.state() == state::operation_enabled) {
                ASSERT_EQ(control.goal(), state::operation_enabled) << "the motor got power on the way to another goal";
            }
        }
        ASSERT_TRUE(says == progress::reached or says == progress::refused or says == progress::faulted)
            << "schedule " << schedule << ", goal " << static_cast<int>(control.goal()) << ", state "
            << static_cast<int>(drive.state()) << ", says " << static_cast<int>(says);
        reached += says == progress::reached ? 1 : 0;
        if (says == progress::reached) { ASSERT_EQ(drive.state(), control.goal()); }
    }
    EXPECT_GT(reached, 9'900);  // on a quiet line there is hardly a reason not to
}

TEST(controller, reaches_every_goal_from_every_state_within_the_path_s_words)
{
    constexpr std::array statuses{0x0210U, switch_on_disabled, ready,          switched_on,
                                  operation_enabled, quick_stop_active, fault_reaction, fault};
    for (std::size_t s = 0; s < statuses.size(); ++s) {
        for (unsigned g = 1; g <= 4; ++g) {
            controller control;
            control.set_goal(static_cast<state>(g));
            auto const says = control.update(word_of(statuses[s]));
            auto const now  = next(static_cast<state>(s), static_cast<state>(g));
            if (s == 7) {
                EXPECT_EQ(says, progress::faulted);
            } else {
                EXPECT_EQ(says, now == step::reached ? progress::reached : progress::waiting) << s << ' ' << g;
            }
        }
    }
}

}  // namespace
