#include <drivecodec/drives/smd/control_mode.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::smd;
using setpoint = setpoint_source;
using control  = control_source;
using program  = program_source;

struct printed_row {
    control_mode    mode;
    setpoint_source speed;
    control_source  start_and_stop;
    program_source  parameters;
};

/// smd manual, table 13; the same in table 4 for 8 to 11, and at parameter C01.
constexpr std::array<printed_row, 12> printed{{
    {control_mode::analog_terminal_keypad, setpoint::analog, control::terminal, program::keypad},
    {control_mode::c40_terminal_keypad, setpoint::c40, control::terminal, program::keypad},
    {control_mode::analog_terminal_lecom, setpoint::analog, control::terminal, program::lecom},
    {control_mode::lecom, setpoint::lecom, control::lecom, program::lecom},
    {control_mode::analog_terminal_remote_keypad, setpoint::analog, control::terminal, program::remote_keypad},
    {control_mode::c40_terminal_remote_keypad, setpoint::c40, control::terminal, program::remote_keypad},
    {control_mode::analog_remote_keypad, setpoint::analog, control::remote_keypad, program::remote_keypad},
    {control_mode::c40_remote_keypad, setpoint::c40, control::remote_keypad, program::remote_keypad},
    {control_mode::analog_terminal_modbus, setpoint::analog, control::terminal, program::modbus},
    {control_mode::c40_terminal_modbus, setpoint::c40, control::terminal, program::modbus},
    {control_mode::analog_modbus, setpoint::analog, control::modbus, program::modbus},
    {control_mode::c40_modbus, setpoint::c40, control::modbus, program::modbus},
}};

TEST(smd_control_mode, has_the_three_sources_of_the_manual)
{
    for (std::size_t number = 0; number < printed.size(); ++number) {
        auto const& row  = printed[number];
        auto const  mode = static_cast<control_mode>(number);
        EXPECT_EQ(mode, row.mode);
        EXPECT_EQ(*setpoint_source_of(mode), row.speed) << number;
        EXPECT_EQ(*control_source_of(mode), row.start_and_stop) << number;
        EXPECT_EQ(*program_source_of(mode), row.parameters) << number;
    }
    VERIFY(*setpoint_source_of(control_mode{3}) == setpoint::lecom);
    VERIFY(*control_source_of(control_mode{8}) == control::terminal);
    VERIFY(*program_source_of(control_mode{11}) == program::modbus);
}

TEST(smd_control_mode, lets_modbus_control_at_10_and_11_and_watch_at_8_and_9)
{
    for (unsigned number = 0; number <= 0xFFFF; ++number) {
        auto const mode = control_mode{static_cast<std::uint16_t>(number)};
        ASSERT_EQ(modbus_controls(mode), number == 10 or number == 11) << number;
        ASSERT_EQ(modbus_monitors(mode), number == 8 or number == 9) << number;
        // Modbus programs the drive in each of these modes, and in no other; it controls where it is the control source.
        auto const has_modbus = modbus_controls(mode) or modbus_monitors(mode);
        ASSERT_EQ(program_source_of(mode) == program::modbus, has_modbus) << number;
        ASSERT_EQ(control_source_of(mode) == control::modbus, modbus_controls(mode)) << number;
    }
}

TEST(smd_control_mode, that_is_unknown_has_no_sources)
{
    for (unsigned number = 12; number <= 0xFFFF; ++number) {
        auto const mode = control_mode{static_cast<std::uint16_t>(number)};
        auto const no   = error{errc::bad_value, 0};
        ASSERT_TRUE(setpoint_source_of(mode) == no and control_source_of(mode) == no and program_source_of(mode) == no);
    }
    for (std::size_t number = 0; number < control_mode_codes.size(); ++number) {
        EXPECT_EQ(control_mode_codes[number], number);
    }
}

}  // namespace
