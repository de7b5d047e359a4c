#include <drivecodec/cia402/command.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec::cia402;

constexpr std::array all_commands{command::shutdown,          command::switch_on,       command::enable_operation,
                                  command::disable_operation, command::disable_voltage, command::quick_stop,
                                  command::fault_reset};

constexpr control_word word_of(unsigned raw)
{
    return control_word::from_raw(static_cast<std::uint16_t>(raw));
}

TEST(command, applied_to_zero_is_the_example_that_every_manual_prints)
{
    VERIFY(apply(command::shutdown, {}).raw == 0x0006);
    VERIFY(apply(command::switch_on, {}).raw == 0x0007);
    VERIFY(apply(command::enable_operation, {}).raw == 0x000F);
    VERIFY(apply(command::disable_operation, {}).raw == 0x0007);
    VERIFY(apply(command::disable_voltage, {}).raw == 0x0000);
    VERIFY(apply(command::quick_stop, {}).raw == 0x0002);
    VERIFY(apply(command::fault_reset, {}).raw == 0x0080);
}

TEST(command, sets_its_own_bits_and_keeps_all_others)
{
    struct expectation {
        unsigned mask;
        unsigned value;
    };
    constexpr std::array<expectation, 7> expected{{{0x0087, 0x0006},
                                                   {0x008F, 0x0007},
                                                   {0x008F, 0x000F},
                                                   {0x008F, 0x0007},
                                                   {0x0082, 0x0000},
                                                   {0x0086, 0x0002},
                                                   {0x0080, 0x0080}}};
    for (std::size_t i = 0; i < all_commands.size(); ++i) {
        for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
            auto const applied = apply(all_commands[i], word_of(raw)).raw;
            ASSERT_EQ(applied & expected[i].mask, expected[i].value) << i << ' ' << raw;
            ASSERT_EQ(applied & ~expected[i].mask, raw & ~expected[i].mask) << i << ' ' << raw;
        }
    }
}

TEST(command, but_the_reset_lowers_the_reset_bit)
{
    for (auto const given : all_commands) {
        auto const applied = apply(given, word_of(0xFFFF));
        EXPECT_EQ(applied.test(control_word::fault_reset), given == command::fault_reset);
    }
}

TEST(command, uses_five_bits)
{
    VERIFY(command_bits == 0x008F);
    VERIFY(command_count == all_commands.size());
}

/// By the table of the standard, bit for bit, level by level.
constexpr command expected_command(unsigned raw, state present)
{
    if ((raw & 0x0002U) == 0) { return command::disable_voltage; }
    if ((raw & 0x0004U) == 0) { return command::quick_stop; }
    if ((raw & 0x0001U) == 0) { return command::shutdown; }
    if ((raw & 0x0008U) != 0) { return command::enable_operation; }
    return present == state::operation_enabled ? command::disable_operation : command::switch_on;
}

TEST(command, is_found_in_every_word_in_every_state)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        for (unsigned i = 0; i < state_count; ++i) {
            auto const present = static_cast<state>(i);
            ASSERT_EQ(decode_command(word_of(raw), present), expected_command(raw, present)) << raw << ' ' << i;
        }
    }
}

TEST(command, named_0007_is_named_by_the_present_state)
{
    VERIFY(decode_command(word_of(0x0007), state::ready_to_switch_on) == command::switch_on);
    VERIFY(decode_command(word_of(0x0007), state::operation_enabled) == command::disable_operation);
}

}  // namespace
