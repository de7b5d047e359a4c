#include <drivecodec/text/cia402/names.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec::cia402;

TEST(text_cia402, has_a_name_for_every_state_command_event_and_progress)
{
    EXPECT_EQ(names_of_all_values<state>().size(), state_count);
    EXPECT_EQ(names_of_all_values<command>().size(), command_count);
    EXPECT_EQ(names_of_all_values<event>().size(), 5);
    EXPECT_EQ(names_of_all_values<progress>().size(), 5);
    EXPECT_EQ(names_of_all_values<homing::progress>().size(), 6);
    VERIFY(to_string(state::quick_stop_active) == "quick_stop_active");
    VERIFY(to_string(command::fault_reset) == "fault_reset");
    VERIFY(to_string(homing::progress::error_at_standstill) == "error_at_standstill");
    VERIFY(to_string(cause{command::shutdown}) == "shutdown" and to_string(cause{event::power_on}) == "power_on");
}

TEST(text_cia402, has_a_name_for_every_mode_of_operation)
{
    std::set<std::string_view> names;
    for (int number = -128; number <= 127; ++number) {
        names.insert(to_string(static_cast<mode_of_operation>(number)));
    }
    EXPECT_EQ(names.size(), 11U + 1U);  // and the empty one
    VERIFY(to_string(mode_of_operation{6}) == "homing" and to_string(mode_of_operation{5}).empty());
}

}  // namespace
