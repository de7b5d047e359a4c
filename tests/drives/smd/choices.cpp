#include <drivecodec/drives/smd/choices.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;

template <typename Enum>
constexpr unsigned code(Enum choice)
{
    return static_cast<unsigned>(choice);
}

// The numbers of section 6.2.
TEST(smd_choices, are_the_numbers_of_the_manual)
{
    VERIFY(code(smd::load_defaults::load_60_hz_defaults) == 2
           and code(smd::load_defaults::translate_compatible_epm) == 4);
    VERIFY(code(smd::digital_input_function::activate_fixed_setpoint_1) == 1);
    VERIFY(code(smd::digital_input_function::quick_stop) == 5 and code(smd::digital_input_function::trip_reset) == 11);
    VERIFY(code(smd::digital_input_function::activate_fixed_pi_setpoint_2) == 15);
    VERIFY(code(smd::output_function::fault) == 1 and code(smd::output_function::threshold_exceeded) == 7);
    VERIFY(code(smd::output_function::feedback_outside_alarm_range) == 10);
    VERIFY(code(smd::operating_mode::linear_with_constant_boost) == 2);
    VERIFY(code(smd::chopper_frequency::chopper_8_khz) == 2);
    VERIFY(code(smd::analog_input_deadband::deadband_disabled) == 1);
    VERIFY(code(smd::analog_input::input_4_to_20_ma_monitored) == 4);
    VERIFY(code(smd::input_voltage::high) == 2);
    VERIFY(code(smd::analog_output::dynamic_braking) == 5 and code(smd::analog_output::load_on_0_to_10_v) == 3);
    VERIFY(code(smd::serial_format::format_8e1) == 2);
    VERIFY(code(smd::start_condition::auto_start_if_high) == 1);
    VERIFY(code(smd::fault_mode::monitor_and_edit) == 1);
    VERIFY(code(smd::trip_reset::auto_reset) == 1);
    VERIFY(code(smd::pi_enable::pi_reverse_acting) == 2);
    VERIFY(code(smd::power_up_state::inhibit) == 1);
    VERIFY(code(smd::serial_timeout_action::controller_inhibit) == 1);
    VERIFY(code(smd::serial_timeout_action::trip_fault_fc3) == 3);
}

}  // namespace
