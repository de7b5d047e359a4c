#include <drivecodec/text/cia402/describe.hpp>

#include "support/verify.hpp"

#include <string>

namespace {

using namespace drivecodec::cia402;

std::string text_of(unsigned raw, bool is_status, state present = state::switch_on_disabled)
{
    std::array<char, 200> room{};
    auto const            word = static_cast<std::uint16_t>(raw);
    return std::string{is_status ? describe(status_word::from_raw(word), room)
                                 : describe(control_word::from_raw(word), room, present)};
}

TEST(text_cia402, explains_a_statusword)
{
    EXPECT_EQ(text_of(0x0637, true), "0637 operation_enabled voltage_enabled remote target_reached");
    EXPECT_EQ(text_of(0x0040, true), "0040 switch_on_disabled");
    EXPECT_EQ(text_of(0x08C0, true), "08C0 switch_on_disabled warning internal_limit_active");
    EXPECT_EQ(text_of(0x0002, true), "0002 no_state");
    EXPECT_EQ(text_of(0xF140, true), "F140 switch_on_disabled +F100");  // bits that only a mode or a maker knows
}

TEST(text_cia402, explains_a_controlword)
{
    EXPECT_EQ(text_of(0x0006, false), "0006 shutdown");
    EXPECT_EQ(text_of(0x0007, false, state::ready_to_switch_on), "0007 switch_on");
    EXPECT_EQ(text_of(0x0007, false, state::operation_enabled), "0007 disable_operation");
    EXPECT_EQ(text_of(0x010F, false), "010F enable_operation halt");
    EXPECT_EQ(text_of(0x0080, false), "0080 disable_voltage fault_reset");
    EXPECT_EQ(text_of(0x080F, false), "080F enable_operation +0800");
}

TEST(text_cia402, says_that_it_did_not_fit)
{
    std::array<char, 12> room{};
    EXPECT_EQ(describe(status_word::from_raw(0x0637), room), "0637 oper...");
}

}  // namespace
