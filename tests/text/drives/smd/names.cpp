#include <drivecodec/text/drives/smd/names.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec::smd;
using names = std::set<std::string_view>;

TEST(text_smd, has_a_name_for_every_enumerator)
{
    EXPECT_EQ(names_of_all_values<command>(),
              (names{"update_buffers", "lock", "stop", "start", "set_reverse", "set_forward", "serial_speed_reference",
                     "local_speed_reference"}));
    EXPECT_EQ(names_of_all_values<command_fault>(),
              (names{"no_command", "unused_bit", "several_with_stop", "several"}));
    EXPECT_EQ(names_of_all_values<family>(), (names{"qc", "mc", "sc", "mch", "smd", "tc", "tmd", "smv"}));
    EXPECT_EQ(names_of_all_values<operational_status>(),
              (names{"fault_lockout", "fault", "start_pending", "stop", "dc_brake", "run_at_0_hz", "run", "accel",
                     "decel", "current_limit", "decel_override", "lower_transistors_switching_on", "off", "inhibit"}));
    EXPECT_EQ(
        names_of_all_values<control_mode>(),
        (names{"analog_terminal_keypad", "c40_terminal_keypad", "analog_terminal_lecom", "lecom",
               "analog_terminal_remote_keypad", "c40_terminal_remote_keypad", "analog_remote_keypad",
               "c40_remote_keypad", "analog_terminal_modbus", "c40_terminal_modbus", "analog_modbus", "c40_modbus"}));
    EXPECT_EQ(names_of_all_values<setpoint_source>(), (names{"analog", "c40", "lecom"}));
    EXPECT_EQ(names_of_all_values<control_source>(), (names{"terminal", "lecom", "remote_keypad", "modbus"}));
    EXPECT_EQ(names_of_all_values<program_source>(), (names{"keypad", "lecom", "remote_keypad", "modbus"}));
    EXPECT_EQ(names_of_all_values<speed_source>(),
              (names{"analog", "preset_c40", "preset_1", "preset_2", "preset_3", "mop", "serial"}));
    EXPECT_EQ(names_of_all_values<speed_reference>(), (names{"serial", "local"}));
}

TEST(text_smd, names_the_value_that_it_is_given)
{
    VERIFY(to_string(command::start) == "start" and to_string(command{0x000C}).empty());
    VERIFY(to_string(command_fault::several) == "several");
    VERIFY(to_string(family{69}) == "smd" and to_string(family{67}).empty());
    VERIFY(to_string(operational_status{13}) == "inhibit" and to_string(operational_status{14}).empty());
    VERIFY(to_string(control_mode{11}) == "c40_modbus" and to_string(control_mode{12}).empty());
    VERIFY(to_string(setpoint_source::c40) == "c40" and to_string(control_source::terminal) == "terminal");
    VERIFY(to_string(program_source::keypad) == "keypad");
    VERIFY(to_string(speed_source{6}) == "serial" and to_string(speed_reference{1}) == "local");
}

}  // namespace
