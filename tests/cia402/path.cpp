#include <drivecodec/cia402/path.hpp>

#include "cia402/drive_in.hpp"
#include "support/verify.hpp"

#include <array>
#include <vector>

namespace {

using namespace drivecodec::cia402;
using drivecodec::errc;

constexpr std::array all_ways{way{false, false}, way{true, false}, way{false, true}, way{true, true}};

/// How many transitions the shortest way takes, by a search over the table that knows nothing of `next`; -1 for none.
/// Neither faults nor quick stops are made on purpose, and the motor gets power only where it is the goal.
int shortest(state from, state goal, way chosen)
{
    if (goal == state::quick_stop_active and from != state::operation_enabled and from != goal) { return -1; }
    std::array<int, state_count> distance{};
    distance.fill(-1);
    distance[static_cast<std::size_t>(from)] = 0;
    std::vector<state> queue{from};
    for (std::size_t head = 0; head < queue.size(); ++head) {
        auto const here = queue[head];
        if (here == state::operation_enabled and here != from) { continue; }  // only ever the end of a way
        for (auto const& row : transitions) {
            auto const is_made_on_purpose =
                row.cause != cause{event::fault} and row.cause != cause{event::quick_stop_finished};
            auto const is_offered = row.number != 16 or chosen.resumes_from_quick_stop;
            auto const to         = static_cast<std::size_t>(row.to);
            if (row.from.contains(here) and is_made_on_purpose and is_offered and distance[to] < 0) {
                distance[to] = distance[static_cast<std::size_t>(here)] + 1;
                queue.push_back(row.to);
            }
        }
    }
    return distance[static_cast<std::size_t>(goal)];
}

TEST(path, replayed_against_the_drive_s_side_reaches_its_goal_by_the_shortest_way)
{
    for (auto const chosen : all_ways) {
        for (unsigned f = 0; f < state_count; ++f) {
            for (unsigned g = 0; g < state_count; ++g) {
                auto const from = static_cast<state>(f);
                auto const goal = static_cast<state>(g);
                auto const made = path::between(from, goal, chosen);
                if (not is_goal(goal) or shortest(from, goal, chosen) < 0) {
                    ASSERT_FALSE(made) << f << ' ' << g;
                    EXPECT_EQ(made.error(), (drivecodec::error{errc::unreachable, 0}));
                    continue;
                }
                ASSERT_TRUE(made) << f << ' ' << g;
                EXPECT_EQ(static_cast<int>(made->size()), shortest(from, goal, chosen)) << f << ' ' << g;

                auto drive = drive_in(from, {.resumes_from_quick_stop = chosen.resumes_from_quick_stop});
                ASSERT_EQ(drive.state(), from);
                for (auto const& row : *made) {
                    if (row.cause == cause{event::initialised}) { drive.initialised(); }
                    if (row.cause == cause{event::fault_handled}) { drive.fault_handled(); }
                    if (not row.cause.is_automatic()) { drive.receive(apply(row.cause.command(), {})); }
                    // 000F goes through Switched on at once.
                    auto const went_through =
                        chosen.straight_to_operation_enabled and row.number == 3 and goal == state::operation_enabled;
                    EXPECT_EQ(drive.state(), went_through ? goal : row.to) << f << ' ' << g << ' ' << int{row.number};
                    EXPECT_TRUE(row.to != state::operation_enabled or goal == row.to) << f << ' ' << g;
                }
                EXPECT_EQ(drive.state(), goal) << f << ' ' << g;
            }
        }
    }
}

/// The same replay as a constant: every way that is said to exist leads from row to row and ends in its goal.
constexpr bool all_paths_reach_their_goals()
{
    for (auto const chosen : all_ways) {
        for (unsigned f = 0; f < state_count; ++f) {
            for (unsigned g = 0; g < state_count; ++g) {
                auto       present = static_cast<state>(f);
                auto const goal    = static_cast<state>(g);
                auto const made    = path::between(present, goal, chosen);
                if (not made) { continue; }
                auto drive = drive_in(present, {.resumes_from_quick_stop = chosen.resumes_from_quick_stop});
                for (auto const& row : *made) {
                    if (not row.from.contains(present)) { return false; }
                    if (row.to == state::operation_enabled and row.to != goal) { return false; }
                    present = row.to;
                    if (row.cause == cause{event::initialised}) { drive.initialised(); }
                    if (row.cause == cause{event::fault_handled}) { drive.fault_handled(); }
                    if (not row.cause.is_automatic()) { drive.receive(apply(row.cause.command(), {})); }
                }
                if (present != goal or drive.state() != goal) { return false; }
            }
        }
    }
    return true;
}
static_assert(all_paths_reach_their_goals());

constexpr auto way_up = path::between(state::fault_reaction_active, state::operation_enabled);

TEST(path, is_a_constant)
{
    static_assert(way_up->size() == path::max_size);
    constexpr auto numbers = [] {
        std::array<int, path::max_size> seen{};
        std::size_t                     count = 0;
        for (auto const& row : *way_up) { seen[count++] = row.number; }
        return seen;
    }();
    VERIFY(numbers == std::array{14, 15, 2, 3, 4});
    VERIFY(path::between(state::switched_on, state::switched_on)->empty());
    VERIFY(path::between(state::operation_enabled, state::quick_stop_active)->size() == 1);
}

TEST(path, straight_to_operation_enabled_is_3_and_4_by_one_command)
{
    constexpr auto straight =
        path::between(state::ready_to_switch_on, state::operation_enabled, way{.straight_to_operation_enabled = true});
    VERIFY(straight->size() == 2 and (*straight)[0].number == 3 and (*straight)[1].number == 4);
    VERIFY((*straight)[0].cause == cause{command::enable_operation});
    VERIFY((*straight)[1].cause == cause{command::enable_operation});
}

}  // namespace
