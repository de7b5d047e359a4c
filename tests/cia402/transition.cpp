#include <drivecodec/cia402/transition.hpp>

#include "support/verify.hpp"

#include <array>
#include <set>
#include <tuple>

namespace {

using namespace drivecodec::cia402;

constexpr auto not_ready = state::not_ready_to_switch_on;
constexpr auto disabled  = state::switch_on_disabled;
constexpr auto ready     = state::ready_to_switch_on;
constexpr auto on        = state::switched_on;
constexpr auto enabled   = state::operation_enabled;
constexpr auto quick     = state::quick_stop_active;
constexpr auto reaction  = state::fault_reaction_active;
constexpr auto faulty    = state::fault;

struct expected_row {
    int   number;
    state from;
    state to;
    cause why;
};

/// IEC 61800-7-201, figure of the finite state automaton and the table of transitions, arrow by arrow; 0 has no from.
constexpr std::array expected{
    expected_row{1, not_ready, disabled, event::initialised},
    expected_row{2, disabled, ready, command::shutdown},
    expected_row{3, ready, on, command::switch_on},
    expected_row{3, ready, on, command::enable_operation},
    expected_row{4, on, enabled, command::enable_operation},
    expected_row{5, enabled, on, command::disable_operation},
    expected_row{6, on, ready, command::shutdown},
    expected_row{7, ready, disabled, command::disable_voltage},
    expected_row{7, ready, disabled, command::quick_stop},
    expected_row{8, enabled, ready, command::shutdown},
    expected_row{9, enabled, disabled, command::disable_voltage},
    expected_row{10, on, disabled, command::disable_voltage},
    expected_row{10, on, disabled, command::quick_stop},
    expected_row{11, enabled, quick, command::quick_stop},
    expected_row{12, quick, disabled, command::disable_voltage},
    expected_row{12, quick, disabled, event::quick_stop_finished},
    expected_row{13, not_ready, reaction, event::fault},
    expected_row{13, disabled, reaction, event::fault},
    expected_row{13, ready, reaction, event::fault},
    expected_row{13, on, reaction, event::fault},
    expected_row{13, enabled, reaction, event::fault},
    expected_row{13, quick, reaction, event::fault},
    expected_row{14, reaction, faulty, event::fault_handled},
    expected_row{15, faulty, disabled, command::fault_reset},
    expected_row{16, quick, enabled, command::enable_operation},
};

constexpr cause cause_number(unsigned i)
{
    return i < command_count ? cause{static_cast<command>(i)} : cause{static_cast<event>(i - command_count)};
}
constexpr unsigned cause_count = command_count + 5;

TEST(transition, table_is_the_standard_s_for_every_state_and_cause)
{
    std::size_t seen = 0;
    for (unsigned s = 0; s < state_count; ++s) {
        for (unsigned c = 0; c < cause_count; ++c) {
            auto const  from = static_cast<state>(s);
            auto const* row  = find_transition(from, cause_number(c));

            expected_row const* wanted = nullptr;
            for (auto const& each : expected) {
                if (each.from == from and each.why == cause_number(c)) { wanted = &each; }
            }
            ASSERT_EQ(row != nullptr, wanted != nullptr) << s << ' ' << c;
            if (row == nullptr) { continue; }
            ++seen;
            EXPECT_EQ(row->number, wanted->number);
            EXPECT_EQ(row->to, wanted->to);
        }
    }
    EXPECT_EQ(seen, expected.size());
}

TEST(transition, numbers_are_0_to_16)
{
    std::set<int> numbers;
    for (auto const& row : transitions) { numbers.insert(row.number); }
    EXPECT_EQ(numbers.size(), 17U);
    EXPECT_EQ(*numbers.rbegin(), 16);
}

TEST(transition, of_power_on_comes_from_no_state)
{
    VERIFY(transitions[0].number == 0 and transitions[0].from.empty() and transitions[0].to == not_ready);
    VERIFY(transitions[0].cause == cause{event::power_on});
}

TEST(transition, depends_on_the_quick_stop_option_code_only_out_of_quick_stop_active)
{
    for (auto const& row : transitions) {
        auto const wanted = row.number == 16                                 ? quick_stop_condition::stays
                            : row.cause == cause{event::quick_stop_finished} ? quick_stop_condition::leaves
                                                                             : quick_stop_condition::none;
        EXPECT_EQ(row.condition, wanted) << int{row.number};
    }
}

TEST(cause, is_a_command_or_an_event)
{
    VERIFY(not cause{command::fault_reset}.is_automatic()
           and cause{command::fault_reset}.command() == command::fault_reset);
    VERIFY(cause{event::power_on}.is_automatic() and cause{event::power_on}.event() == event::power_on);
    for (unsigned a = 0; a < cause_count; ++a) {
        for (unsigned b = 0; b < cause_count; ++b) { EXPECT_EQ(cause_number(a) == cause_number(b), a == b); }
    }
}

TEST(state_set, contains_what_it_was_made_of)
{
    constexpr state_set some{state::fault, state::switched_on};
    for (unsigned s = 0; s < state_count; ++s) {
        auto const each = static_cast<state>(s);
        EXPECT_EQ(some.contains(each), each == state::fault or each == state::switched_on);
        EXPECT_EQ(state_set{each}.contains(state::fault), each == state::fault);
        EXPECT_FALSE(state_set{}.contains(each));
    }
    VERIFY(state_set{}.empty() and not some.empty());
}

}  // namespace
