#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/smd/status_block.hpp>

#include "support/verify.hpp"

#include <array>
#include <string>

namespace {

using namespace drivecodec::smd;
using drivecodec::describe;

template <typename Thing>
std::string text_of(Thing const& thing)
{
    std::array<char, 300> room{};
    return std::string{describe(thing, room)};
}

TEST(text_smd_status_block, is_one_line_that_begins_with_what_the_drive_does)
{
    EXPECT_EQ(
        text_of(status_block::from_words({0x0201, 0x019C, 0x6406, 0x000B, 0x0600, 0x0001})),
        "run 41.2 Hz forward, command 51.3 Hz reverse, load 100 %, no_fault, speed_source serial, speed_reference "
        "serial, control_mode c40_modbus");
    EXPECT_EQ(
        text_of(status_block::from_words({0, 0, 0x0001, 0x0008, 0x0001, 0x1800})),
        "fault 0.0 Hz forward, command 0.0 Hz forward, load 0 %, communication_fault 24 FC3, speed_source analog, "
        "speed_reference local, control_mode analog_terminal_modbus");
    EXPECT_EQ(text_of(status_block{}),
              "fault_lockout 0.0 Hz forward, command 0.0 Hz forward, load 0 %, no_fault, speed_source analog, "
              "speed_reference serial, control_mode analog_terminal_keypad");
}

TEST(text_smd_status_block, shows_codes_without_a_name_as_numbers)
{
    EXPECT_EQ(text_of(status_block::from_words({0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF})),
              "255 6553.5 Hz 255, command 6553.5 Hz 255, load 255 %, fault 255, speed_source 255, speed_reference 255, "
              "control_mode 255");
}

TEST(text_smd_status_words, say_what_a_read_of_one_register_says)
{
    EXPECT_EQ(text_of(load_and_status::from_raw(0x6406)), "100 %, run");
    EXPECT_EQ(text_of(direction_and_mode::from_raw(0x010B)), "reverse, c40_modbus");
    EXPECT_EQ(text_of(source_and_reference::from_raw(0x0600)), "speed_source serial, speed_reference serial");
    EXPECT_EQ(text_of(fault_and_direction::from_raw(0x1801)), "communication_fault 24 FC3, reverse");
    EXPECT_EQ(text_of(fault_and_direction::from_raw(0xFFFF)), "fault 255, 255");
}

}  // namespace
