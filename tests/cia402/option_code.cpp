#include <drivecodec/cia402/option_code.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::cia402;

// IEC 61800-7-201, objects 605Ah to 605Eh.
static_assert(static_cast<int>(quick_stop_option::disable_drive) == 0);
static_assert(static_cast<int>(quick_stop_option::slow_down_ramp) == 1);
static_assert(static_cast<int>(quick_stop_option::quick_stop_ramp) == 2);
static_assert(static_cast<int>(quick_stop_option::current_limit) == 3);
static_assert(static_cast<int>(quick_stop_option::voltage_limit) == 4);
static_assert(static_cast<int>(quick_stop_option::slow_down_ramp_and_stay) == 5);
static_assert(static_cast<int>(quick_stop_option::quick_stop_ramp_and_stay) == 6);
static_assert(static_cast<int>(quick_stop_option::current_limit_and_stay) == 7);
static_assert(static_cast<int>(quick_stop_option::voltage_limit_and_stay) == 8);
static_assert(static_cast<int>(shutdown_option::disable_drive) == 0);
static_assert(static_cast<int>(disable_operation_option::disable_drive) == 0);
static_assert(static_cast<int>(halt_option::quick_stop_ramp) == 2);
static_assert(static_cast<int>(halt_option::current_limit) == 3);
static_assert(static_cast<int>(fault_reaction_option::slow_down_ramp) == 1);
static_assert(static_cast<int>(fault_reaction_option::quick_stop_ramp) == 2);
static_assert(static_cast<int>(fault_reaction_option::current_limit) == 3);
static_assert(static_cast<int>(shutdown_option::slow_down_ramp) == 1);
static_assert(static_cast<int>(disable_operation_option::slow_down_ramp) == 1);
static_assert(static_cast<int>(halt_option::slow_down_ramp) == 1);
static_assert(static_cast<int>(halt_option::voltage_limit) == 4);
static_assert(static_cast<int>(fault_reaction_option::disable_drive) == 0);
static_assert(static_cast<int>(fault_reaction_option::voltage_limit) == 4);

TEST(quick_stop_option, stays_with_5_to_8)
{
    for (int code = -0x8000; code <= 0x7FFF; ++code) {
        ASSERT_EQ(stays_in_quick_stop(static_cast<quick_stop_option>(code)), code >= 5 and code <= 8) << code;
    }
}

}  // namespace
