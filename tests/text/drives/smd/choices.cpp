#include <drivecodec/text/drives/smd/choices.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec;

TEST(text_smd_choices, have_a_name_for_every_enumerator)
{
    EXPECT_EQ(names_of_all_values<smd::version>().size(), 2U);
    EXPECT_EQ(names_of_all_values<smd::load_defaults>().size(), 5U);
    EXPECT_EQ(names_of_all_values<smd::digital_input_function>().size(), 15U);
    EXPECT_EQ(names_of_all_values<smd::output_function>().size(), 11U);
    EXPECT_EQ(names_of_all_values<smd::operating_mode>().size(), 4U);
    EXPECT_EQ(names_of_all_values<smd::chopper_frequency>().size(), 4U);
    EXPECT_EQ(names_of_all_values<smd::analog_input_deadband>().size(), 2U);
    EXPECT_EQ(names_of_all_values<smd::analog_input>().size(), 5U);
    EXPECT_EQ(names_of_all_values<smd::input_voltage>().size(), 3U);
    EXPECT_EQ(names_of_all_values<smd::analog_output>().size(), 6U);
    EXPECT_EQ(names_of_all_values<smd::serial_format>().size(), 4U);
    EXPECT_EQ(names_of_all_values<smd::start_condition>().size(), 2U);
    EXPECT_EQ(names_of_all_values<smd::fault_mode>().size(), 2U);
    EXPECT_EQ(names_of_all_values<smd::trip_reset>().size(), 2U);
    EXPECT_EQ(names_of_all_values<smd::pi_enable>().size(), 3U);
    EXPECT_EQ(names_of_all_values<smd::power_up_state>().size(), 2U);
    EXPECT_EQ(names_of_all_values<smd::serial_timeout_action>().size(), 4U);
    VERIFY(to_string(smd::pv507) == "pv507");
    VERIFY(to_string(smd::serial_timeout_action::trip_fault_fc3) == "trip_fault_fc3");
}

}  // namespace
