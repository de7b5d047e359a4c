#include <drivecodec/cia402/next.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::cia402;

TEST(next, goes_up_one_state_at_a_time)
{
    constexpr auto goal = state::operation_enabled;
    VERIFY(next(state::switch_on_disabled, goal) == command::shutdown);
    VERIFY(next(state::ready_to_switch_on, goal) == command::switch_on);
    VERIFY(next(state::switched_on, goal) == command::enable_operation);
    VERIFY(next(state::operation_enabled, goal) == step::reached);
}

TEST(next, goes_straight_from_ready_only_if_asked_to)
{
    constexpr way straight{.straight_to_operation_enabled = true};
    VERIFY(next(state::ready_to_switch_on, state::operation_enabled, straight) == command::enable_operation);
    VERIFY(next(state::ready_to_switch_on, state::switched_on, straight) == command::switch_on);
    VERIFY(next(state::switch_on_disabled, state::operation_enabled, straight) == command::shutdown);
}

TEST(next, goes_down_at_once)
{
    VERIFY(next(state::operation_enabled, state::switched_on) == command::disable_operation);
    VERIFY(next(state::operation_enabled, state::ready_to_switch_on) == command::shutdown);
    VERIFY(next(state::operation_enabled, state::switch_on_disabled) == command::disable_voltage);
    VERIFY(next(state::switched_on, state::ready_to_switch_on) == command::shutdown);
    VERIFY(next(state::switched_on, state::switch_on_disabled) == command::disable_voltage);
    VERIFY(next(state::ready_to_switch_on, state::switch_on_disabled) == command::disable_voltage);
}

TEST(next, leaves_quick_stop_as_the_device_allows)
{
    constexpr way resumes{.resumes_from_quick_stop = true};
    VERIFY(next(state::quick_stop_active, state::operation_enabled) == command::disable_voltage);
    VERIFY(next(state::quick_stop_active, state::operation_enabled, resumes) == command::enable_operation);
    // 16 and 8 would be as short as 12 and 2, but the motor would have power again on the way down.
    VERIFY(next(state::quick_stop_active, state::ready_to_switch_on, resumes) == command::disable_voltage);
    VERIFY(next(state::quick_stop_active, state::switched_on, resumes) == command::disable_voltage);
}

TEST(next, reaches_quick_stop_only_from_operation_enabled)
{
    for (unsigned s = 0; s < state_count; ++s) {
        auto const from   = static_cast<state>(s);
        auto const wanted = from == state::operation_enabled   ? step{command::quick_stop}
                            : from == state::quick_stop_active ? step::reached
                                                               : step::unreachable;
        EXPECT_EQ(next(from, state::quick_stop_active), wanted) << s;
    }
}

TEST(next, waits_in_states_that_the_drive_leaves_by_itself_and_resets_a_fault)
{
    for (auto const goal :
         {state::switch_on_disabled, state::ready_to_switch_on, state::switched_on, state::operation_enabled}) {
        EXPECT_EQ(next(state::not_ready_to_switch_on, goal), step::wait);
        EXPECT_EQ(next(state::fault_reaction_active, goal), step::wait);
        EXPECT_EQ(next(state::fault, goal), step{command::fault_reset});
    }
}

TEST(next, says_of_what_cannot_be_commanded_that_it_is_unreachable)
{
    for (auto const goal : {state::not_ready_to_switch_on, state::fault_reaction_active, state::fault}) {
        EXPECT_FALSE(is_goal(goal));
        for (unsigned s = 0; s < state_count; ++s) { EXPECT_EQ(next(static_cast<state>(s), goal), step::unreachable); }
    }
}

TEST(holding_command, keeps_a_goal)
{
    VERIFY(holding_command(state::switch_on_disabled) == command::disable_voltage);
    VERIFY(holding_command(state::ready_to_switch_on) == command::shutdown);
    VERIFY(holding_command(state::switched_on) == command::switch_on);
    VERIFY(holding_command(state::operation_enabled) == command::enable_operation);
    VERIFY(holding_command(state::quick_stop_active) == command::quick_stop);
}

TEST(step, is_a_command_or_none)
{
    VERIFY(step{command::fault_reset}.is_command() and step{command::fault_reset}.command() == command::fault_reset);
    VERIFY(not step::reached.is_command() and not step::wait.is_command() and not step::unreachable.is_command());
    VERIFY(step::reached != step::wait and step::wait != step::unreachable and step::reached != step::unreachable);
}

}  // namespace
