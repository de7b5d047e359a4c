#include <drivecodec/text/drives/vlt6000/names.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec::vlt6000;

TEST(text_vlt6000, has_a_name_for_every_choice)
{
    EXPECT_EQ(names_of_all_values<preset_reference>(),
              (std::set<std::string_view>{"preset_reference_1", "preset_reference_2", "preset_reference_3",
                                          "preset_reference_4"}));
    EXPECT_EQ(names_of_all_values<setup>(), (std::set<std::string_view>{"setup_1", "setup_2", "setup_3", "setup_4"}));
    EXPECT_EQ(names_of_all_values<gating>(),
              (std::set<std::string_view>{"digital_input", "serial_communication", "logic_and", "logic_or"}));
    EXPECT_EQ(names_of_all_values<bus_time_interval_function>(),
              (std::set<std::string_view>{"off", "freeze_output", "stop", "jogging", "max_output_frequency",
                                          "stop_and_trip"}));
}

TEST(text_vlt6000, names_the_choice_that_it_is_given)
{
    VERIFY(to_string(preset_reference{3}) == "preset_reference_4" and to_string(setup{0}) == "setup_1");
    VERIFY(to_string(gating{2}) == "logic_and" and to_string(gating{4}).empty());
    VERIFY(to_string(bus_time_interval_function{3}) == "jogging");
    VERIFY(to_string(bus_time_interval_function{6}).empty());
}

}  // namespace
