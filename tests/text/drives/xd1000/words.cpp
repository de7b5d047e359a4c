#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/xd1000/words.hpp>

#include "support/verify.hpp"

#include <array>
#include <cstdio>
#include <string>

namespace {

using namespace drivecodec::xd1000;
using drivecodec::describe;
using drivecodec::cia402::state;

std::string cmd_text(unsigned raw, state present = state::switch_on_disabled)
{
    std::array<char, 200>   room{};
    drivecodec::text_writer out{room};
    write_text(out, command_word::from_raw(static_cast<std::uint16_t>(raw)), present);
    return std::string{out.view()};
}

std::string eta_text(unsigned raw)
{
    std::array<char, 200> room{};
    return std::string{describe(status_word::from_raw(static_cast<std::uint16_t>(raw)), room)};
}

TEST(text_xd1000_words, name_the_commands_of_the_manual)
{
    EXPECT_EQ(cmd_text(0x0006), "CMD 0006 shutdown");
    EXPECT_EQ(cmd_text(0x0007, state::ready_to_switch_on), "CMD 0007 switch_on");
    EXPECT_EQ(cmd_text(0x000F), "CMD 000F enable_operation");
    EXPECT_EQ(cmd_text(0x0007, state::operation_enabled), "CMD 0007 disable_operation");
    EXPECT_EQ(cmd_text(0x0000), "CMD 0000 disable_voltage");
    EXPECT_EQ(cmd_text(0x0002), "CMD 0002 quick_stop");
    EXPECT_EQ(cmd_text(0x0080), "CMD 0080 disable_voltage fault_reset");
}

TEST(text_xd1000_words, name_halt_and_direction_of_a_command_and_keep_all_else_as_a_number)
{
    EXPECT_EQ(cmd_text(0x010F), "CMD 010F enable_operation halt");
    EXPECT_EQ(cmd_text(0x090F), "CMD 090F enable_operation reverse halt");
    EXPECT_EQ(cmd_text(0xF67F), "CMD F67F enable_operation +F670");
}

TEST(text_xd1000_words, name_the_states_of_the_manual)
{
    EXPECT_EQ(eta_text(0x0250), "ETA 0250 switch_on_disabled remote");
    EXPECT_EQ(eta_text(0x0231), "ETA 0231 ready_to_switch_on remote");
    EXPECT_EQ(eta_text(0x0233), "ETA 0233 switched_on remote");
    EXPECT_EQ(eta_text(0x0637), "ETA 0637 operation_enabled remote reference_reached");
    EXPECT_EQ(eta_text(0x0217), "ETA 0217 quick_stop_active remote");
    EXPECT_EQ(eta_text(0x0218), "ETA 0218 fault remote");
    EXPECT_EQ(eta_text(0x0238), "ETA 0238 fault remote");
}

TEST(text_xd1000_words, name_what_else_a_status_says)
{
    EXPECT_EQ(eta_text(0x0050), "ETA 0050 switch_on_disabled local");
    EXPECT_EQ(eta_text(0x8A37), "ETA 8A37 operation_enabled remote reverse reference_exceeded");
    EXPECT_EQ(eta_text(0x4250), "ETA 4250 switch_on_disabled remote stopped_by_stop_key");
    EXPECT_EQ(eta_text(0x0012), "ETA 0012 no_state local");
    EXPECT_EQ(eta_text(0x33D0), "ETA 33D0 switch_on_disabled remote +3180");
}

/// So that nothing is lost that has no name.
TEST(text_xd1000_words, begin_with_their_number)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        std::array<char, 5> digits{};
        std::snprintf(digits.data(), digits.size(), "%04X", raw);
        ASSERT_EQ(cmd_text(raw).substr(0, 9), "CMD " + std::string{digits.data()} + " ");
        ASSERT_EQ(eta_text(raw).substr(0, 9), "ETA " + std::string{digits.data()} + " ");
    }
}

}  // namespace
