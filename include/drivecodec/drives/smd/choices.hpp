// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

// What parameters are set to, by the number that is transferred. smd manual, section 6.2. A number that the manual does
// not have stays that number. The selections that only PV507 has were printed in bold, which is lost: none is refused.

namespace drivecodec::smd {

namespace detail {

/// All choices of the drive count upwards by one.
inline constexpr std::array<std::uint16_t, 27> numbers{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13,
                                                       14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

[[nodiscard]] consteval std::span<std::uint16_t const> from_to(std::size_t first, std::size_t last)
{
    return std::span{numbers}.subspan(first, last - first + 1);
}

}  // namespace detail

/// C02. To be changed only while the drive is off or inhibited.
enum class load_defaults : std::uint16_t {
    no_action                = 0,  ///< As it is read: loading is complete.
    load_50_hz_defaults      = 1,
    load_60_hz_defaults      = 2,
    load_oem_defaults        = 3,
    translate_compatible_epm = 4,
};

/// CE1, CE2, CE3. 12 to 15 are of parameters that only PV507 has.
enum class digital_input_function : std::uint16_t {
    activate_fixed_setpoint_1    = 1,  ///< JOG1, C37.
    activate_fixed_setpoint_2    = 2,
    dc_braking                   = 3,
    direction_of_rotation        = 4,
    quick_stop                   = 5,
    cw_rotation                  = 6,
    ccw_rotation                 = 7,
    up                           = 8,
    down                         = 9,
    trip_set                     = 10,
    trip_reset                   = 11,
    accel_decel_2                = 12,
    deactivate_pi                = 13,
    activate_fixed_pi_setpoint_1 = 14,
    activate_fixed_pi_setpoint_2 = 15,
};

/// C08, the relay, and c17, digital output A1. 9 and 10 are of parameters that only PV507 has.
enum class output_function : std::uint16_t {
    ready                        = 0,
    fault                        = 1,
    motor_is_running             = 2,
    motor_is_running_cw          = 3,
    motor_is_running_ccw         = 4,
    output_frequency_is_0        = 5,
    frequency_setpoint_reached   = 6,
    threshold_exceeded           = 7,  ///< C17.
    current_limit_reached        = 8,
    feedback_within_alarm_range  = 9,
    feedback_outside_alarm_range = 10,
};

/// C14.
enum class operating_mode : std::uint16_t {
    linear_with_auto_boost         = 0,
    square_law_with_auto_boost     = 1,
    linear_with_constant_boost     = 2,  ///< Vmin boost, C16.
    square_law_with_constant_boost = 3,
};

/// C18.
enum class chopper_frequency : std::uint16_t {
    chopper_4_khz  = 0,
    chopper_6_khz  = 1,
    chopper_8_khz  = 2,
    chopper_10_khz = 3
};

/// C31.
enum class analog_input_deadband : std::uint16_t { deadband_enabled = 0, deadband_disabled = 1 };

/// C34.
enum class analog_input : std::uint16_t {
    input_0_to_10_v            = 0,
    input_0_to_5_v             = 1,
    input_0_to_20_ma           = 2,
    input_4_to_20_ma           = 3,
    input_4_to_20_ma_monitored = 4,
};

/// C90.
enum class input_voltage : std::uint16_t { automatic = 0, low = 1, high = 2 };

/// c11, terminal 62.
enum class analog_output : std::uint16_t {
    none                          = 0,
    output_frequency_on_0_to_10_v = 1,
    output_frequency_on_2_to_10_v = 2,
    load_on_0_to_10_v             = 3,
    load_on_2_to_10_v             = 4,
    dynamic_braking               = 5,
};

/// c25 while C01 is 8 to 11, always at 9600 baud. With any other C01, the same number is a rate of LECOM.
enum class serial_format : std::uint16_t { format_8n2 = 0, format_8n1 = 1, format_8e1 = 2, format_8o1 = 3 };

/// c42: what starts the drive at terminal 28.
enum class start_condition : std::uint16_t { start_after_low_high_change = 0, auto_start_if_high = 1 };

/// c60, of c61.
enum class fault_mode : std::uint16_t { monitor_only = 0, monitor_and_edit = 1 };

/// c70.
enum class trip_reset : std::uint16_t {
    reset_by_signal_or_mains = 0,  ///< Terminal 28, mains switching, or a digital input "TRIP reset".
    auto_reset               = 1,
};

/// d38.
enum class pi_enable : std::uint16_t { pi_disabled = 0, pi_normal_acting = 1, pi_reverse_acting = 2 };

/// n20.
enum class power_up_state : std::uint16_t { quick_stop = 0, inhibit = 1 };

/// n22: what the drive does when nobody has talked to it for longer than n23. smd manual, section 4.4.
enum class serial_timeout_action : std::uint16_t {
    not_active         = 0,
    controller_inhibit = 1,  ///< Coasts to a stop.
    quick_stop         = 2,  ///< Ramps to a stop.
    trip_fault_fc3     = 3,  ///< Trips: fault 24.
};

}  // namespace drivecodec::smd
