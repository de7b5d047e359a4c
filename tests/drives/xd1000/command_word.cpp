#include <drivecodec/cia402/machine.hpp>
#include <drivecodec/cia402/next.hpp>
#include <drivecodec/drives/xd1000/command_word.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec::xd1000;
using drivecodec::cia402::command;
using drivecodec::cia402::control_word;

// xD1000 manual, "Command word description CMD - 8501": each bit.
static_assert(command_word::of(command_word::switch_on).raw == 0x0001);
static_assert(command_word::of(command_word::enable_voltage).raw == 0x0002);
static_assert(command_word::of(command_word::no_quick_stop).raw == 0x0004);
static_assert(command_word::of(command_word::enable_operation).raw == 0x0008);
static_assert(command_word::of(command_word::bit_4).raw == 0x0010);
static_assert(command_word::of(command_word::fault_reset).raw == 0x0080);
static_assert(command_word::of(command_word::halt).raw == 0x0100);
static_assert(command_word{}.with(command_word::direction, direction::reverse).raw == 0x0800);

TEST(xd1000_manual, prints_an_example_value_for_every_command)
{
    VERIFY(command_word{command::shutdown}.raw == 0x0006);
    VERIFY(command_word{command::switch_on}.raw == 0x0007);
    VERIFY(command_word{command::enable_operation}.raw == 0x000F);
    VERIFY(command_word{command::disable_operation}.raw == 0x0007);
    VERIFY(command_word{command::disable_voltage}.raw == 0x0000);
    VERIFY(command_word{command::quick_stop}.raw == 0x0002);
    VERIFY(command_word{command::fault_reset}.raw == 0x0080);
}

TEST(xd1000_manual, calls_bit_1_switch_on_disabled_where_it_enables_voltage)
{
    // "Disable voltage" is the command with a 0 there.
    VERIFY(not command_word{command::disable_voltage}.test(command_word::enable_voltage));
    VERIFY(command_word{command::shutdown}.test(command_word::enable_voltage));
}

TEST(xd1000_manual, says_of_bit_4_that_0_is_free_wheel_but_enables_operation_with_it_at_0)
{
    for (auto const given :
         {command::shutdown, command::switch_on, command::enable_operation, command::disable_operation,
          command::disable_voltage, command::quick_stop, command::fault_reset}) {
        EXPECT_FALSE(command_word{given}.test(command_word::bit_4));
    }
    VERIFY(apply(command::enable_operation, command_word::of(command_word::bit_4)).raw == 0x001F);  // the user's to set
}

TEST(xd1000_manual, marks_bit_3_as_of_no_significance_to_switch_on_yet_000F_enables_operation)
{
    using drivecodec::cia402::decode_command;
    using drivecodec::cia402::state;
    VERIFY(decode_command(command_word::from_raw(0x0007).standard(), state::ready_to_switch_on) == command::switch_on);
    VERIFY(decode_command(command_word::from_raw(0x000F).standard(), state::ready_to_switch_on)
           == command::enable_operation);
}

TEST(xd1000_manual, has_a_row_for_fault_reset_without_saying_that_the_bit_must_return_to_0)
{
    // Any other command lowers it, ready for the next edge; the same word again is no edge.
    auto const raised = command_word{command::fault_reset};
    for (auto const given : {command::shutdown, command::switch_on, command::enable_operation,
                             command::disable_operation, command::disable_voltage, command::quick_stop}) {
        EXPECT_FALSE(apply(given, raised).test(command_word::fault_reset));
    }

    using drivecodec::cia402::state;
    drivecodec::cia402::machine drive;
    drive.initialised();
    auto const fail = [&] {
        drive.fault();
        drive.fault_handled();
    };
    fail();
    drive.receive(raised.standard());
    EXPECT_EQ(drive.state(), state::switch_on_disabled);
    fail();
    for (int again = 0; again < 3; ++again) { drive.receive(raised.standard()); }
    EXPECT_EQ(drive.state(), state::fault);
    drive.receive(command_word{command::disable_voltage}.standard());
    drive.receive(raised.standard());
    EXPECT_EQ(drive.state(), state::switch_on_disabled);
}

TEST(xd1000_manual, numbers_transitions_only_in_a_figure_that_is_missing_and_has_no_16)
{
    // "Restarting is only possible after the drive has changed to the Switch on disabled state."
    using drivecodec::cia402::state;
    drivecodec::cia402::machine drive;
    drive.initialised();
    for (auto const given : {command::shutdown, command::switch_on, command::enable_operation, command::quick_stop}) {
        drive.receive(command_word{given}.standard());
    }
    EXPECT_EQ(drive.state(), state::quick_stop_active);
    drive.receive(command_word{command::enable_operation}.standard());
    EXPECT_EQ(drive.state(), state::quick_stop_active);
    drive.receive(command_word{command::disable_voltage}.standard());
    EXPECT_EQ(drive.state(), state::switch_on_disabled);
    VERIFY(next(state::quick_stop_active, state::operation_enabled).command() == command::disable_voltage);
}

TEST(xd1000_command_word, keeps_halt_direction_and_all_other_bits)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = command_word::from_raw(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(apply(command::enable_operation, word).raw, (raw & 0xFF70U) | 0x000FU);
        ASSERT_EQ(command_word{word.standard()}.raw, raw);
        ASSERT_EQ(word.get(command_word::direction) == direction::reverse, (raw & 0x0800U) != 0);
    }
}

}  // namespace
