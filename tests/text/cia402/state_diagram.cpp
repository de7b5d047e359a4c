#include <drivecodec/text/cia402/state_diagram.hpp>

#include "support/verify.hpp"

#include <string_view>

namespace {

using namespace drivecodec::cia402;

TEST(text_cia402, draws_the_standard_s_state_machine)
{
    std::array<char, 4096>  room{};
    drivecodec::text_writer out{room};
    write_state_diagram(out);
    ASSERT_TRUE(out.is_complete());
    // From the figure of the standard.
    EXPECT_EQ(out.view(), R"(stateDiagram-v2
    [*] --> not_ready_to_switch_on : 0 power_on
    not_ready_to_switch_on --> switch_on_disabled : 1 initialised
    switch_on_disabled --> ready_to_switch_on : 2 shutdown
    ready_to_switch_on --> switched_on : 3 switch_on
    ready_to_switch_on --> switched_on : 3 enable_operation
    switched_on --> operation_enabled : 4 enable_operation
    operation_enabled --> switched_on : 5 disable_operation
    switched_on --> ready_to_switch_on : 6 shutdown
    ready_to_switch_on --> switch_on_disabled : 7 disable_voltage
    ready_to_switch_on --> switch_on_disabled : 7 quick_stop
    operation_enabled --> ready_to_switch_on : 8 shutdown
    operation_enabled --> switch_on_disabled : 9 disable_voltage
    switched_on --> switch_on_disabled : 10 disable_voltage
    switched_on --> switch_on_disabled : 10 quick_stop
    operation_enabled --> quick_stop_active : 11 quick_stop
    quick_stop_active --> switch_on_disabled : 12 disable_voltage
    quick_stop_active --> switch_on_disabled : 12 quick_stop_finished (605Ah 1 to 4)
    any --> fault_reaction_active : 13 fault
    fault_reaction_active --> fault : 14 fault_handled
    fault --> switch_on_disabled : 15 fault_reset
    quick_stop_active --> operation_enabled : 16 enable_operation (605Ah 5 to 8)
)");
}

}  // namespace
