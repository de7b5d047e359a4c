// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/register_row.hpp>
#include <drivecodec/drives/smd/choices.hpp>
#include <drivecodec/drives/smd/command.hpp>
#include <drivecodec/drives/smd/version.hpp>

namespace drivecodec::smd {

/// A register, and where it is in each version. The address that `what` has is not used.
struct versioned_row {
    std::uint16_t        pv400;  ///< `absent` if the version lacks it.
    std::uint16_t        pv507;
    drives::register_row what;

    /// Nothing is at 0.
    static constexpr std::uint16_t absent = 0;

    [[nodiscard]] constexpr std::uint16_t address_in(version which) const noexcept
    {
        return which == smd::pv400 ? pv400 : pv507;
    }
};

/// Of C94, and so of registers 48 and 49. smd manual, sections 5.7 and 5.8, and 6.2.
inline constexpr int largest_password = 999;

namespace detail {

using drives::no_default;
using drives::no_limits_unsigned;
using drives::raw_default;
using drives::raw_limits;
using drives::register_row;
using enum drives::access;
using enum drives::raw_type;
using enum drives::source;

inline constexpr int absent = versioned_row::absent;

/// Where both versions have it.
struct place {
    int pv400;
    int pv507;

    consteval place(int both) : pv400{both}, pv507{both} {}
    consteval place(int in_pv400, int in_pv507) : pv400{in_pv400}, pv507{in_pv507} {}

    [[nodiscard]] consteval versioned_row row(register_row const& what) const
    {
        return {static_cast<std::uint16_t>(pv400), static_cast<std::uint16_t>(pv507), what};
    }
};

[[nodiscard]] consteval versioned_row number(std::string_view code, place at, std::string_view name, int exponent,
                                             unit of, raw_limits limits, raw_default factory_setting,
                                             drives::access may = read_write)
{
    return at.row({0, name, "", code, unsigned_number, static_cast<std::int8_t>(exponent), of, manual, limits,
                   factory_setting, may, manual});
}

[[nodiscard]] consteval versioned_row setting(std::string_view code, place at, std::string_view name, int exponent,
                                              unit of, int min, int max, int factory_setting)
{
    return number(code, at, name, exponent, of, {min, max, manual}, {factory_setting, manual});
}

[[nodiscard]] consteval versioned_row read_out(std::string_view code, place at, std::string_view name, int exponent,
                                               unit of, int min, int max)
{
    return number(code, at, name, exponent, of, {min, max, manual}, no_default, read_only);
}

/// All numbers between two.
[[nodiscard]] consteval versioned_row choice(std::string_view code, place at, std::string_view name, int min, int max,
                                             raw_default factory_setting, drives::access may = read_write)
{
    return at.row({0,
                   name,
                   "",
                   code,
                   enumeration,
                   0,
                   unit::none,
                   manual,
                   {min, max, manual},
                   factory_setting,
                   may,
                   manual,
                   from_to(static_cast<std::size_t>(min), static_cast<std::size_t>(max))});
}

[[nodiscard]] consteval versioned_row word_of(drives::raw_type type, std::string_view code, place at,
                                              std::string_view name, drives::access may)
{
    return at.row({0, name, "", code, type, 0, unit::none, manual, no_limits_unsigned, no_default, may, manual});
}

/// A counter of which the manual has neither unit nor range.
[[nodiscard]] consteval versioned_row counter(std::string_view code, place at, std::string_view name)
{
    return at.row(
        {0, name, "", code, unsigned_number, 0, unit::none, nobody, no_limits_unsigned, no_default, read_only, manual});
}

}  // namespace detail

/// Every register of the drive in the order of the manual, which is that of the addresses in both versions. smd manual,
/// table 6 and section 6.2. Names and codes are the manual's; codes are case sensitive: C01 is not c01.
///
/// Worth a second look: C11 is printed "Minimum Output Freq." too; it is the maximum, as table 6 says of register 40.
/// The limits of register 40 are what C10 and C11 are set to at the time, those of C59, c38 and c81 what c86 and c87
/// are set to: here stand those of the output frequency, and none. Registers 48 and 49 take a password; c78 and c79
/// have no unit.
// clang-format off
inline constexpr std::array<versioned_row, 82> rows = [] {
    using namespace detail;
    using enum unit;
    constexpr auto or_less = [](int last) { return raw_limits{0, last, manual}; };
    return std::array{
        place{1}.row({0, "drive_control", "", "", bits, 0, none, manual, or_less(0x0200), no_default, write_only,
                      manual, command_codes}),
        word_of(enumeration, "", 19, "drive_family",   read_only),
        read_out("", 21, "drive_size", 0, none, 0, 0),
        word_of(bits,        "", 22, "drive_hardware", read_only),
        read_out("", 24, "command_speed", -1, hertz, 0, 2400),
        read_out("", 25, "actual_speed",  -1, hertz, 0, 2400),
        word_of(two_bytes,   "", 26, "load_and_operational_status",         read_only),
        word_of(two_bytes,   "", 27, "actual_direction_and_control_mode",   read_only),
        word_of(two_bytes,   "", 28, "speed_source_and_speed_reference",    read_only),
        word_of(two_bytes,   "", 29, "present_fault_and_commanded_direction", read_only),
        read_out("", 30, "motor_volts", 0, percent, 0, 250),
        number("", 40, "serial_speed_command", -1, hertz, or_less(2400), no_default),
        number("", 48, "unlock_commands",   0, none, or_less(largest_password), no_default, write_only),
        number("", 49, "unlock_parameters", 0, none, or_less(largest_password), no_default, write_only),
        read_out("", 50, "register_version", 0, none, 0, 65535),

        choice ("C01", 51, "setpoint_and_control_source",   0, 11, {0, manual}),
        choice ("C02", 52, "load_lenze_setting",            0, 4,  {0, manual}, read_write_at_standstill),
        choice ("CE1", 53, "configuration_digital_input_e1", 1, 15, {1, manual}),
        choice ("CE2", 54, "configuration_digital_input_e2", 1, 15, {4, manual}),
        choice ("CE3", 55, "configuration_digital_input_e3", 1, 15, {3, manual}),
        choice ("C08", 57, "configuration_relay_output",    0, 10, {1, manual}),
        setting("C09", 58, "network_address",               0,  none,    1,   247,  1),
        setting("C10", 59, "minimum_output_frequency",      -1, hertz,   0,   2400, 0),
        setting("C11", 60, "maximum_output_frequency",      -1, hertz,   75,  2400, 500),
        setting("C12", 61, "acceleration_time",             -1, second,  0,   9990, 50),
        setting("C13", 62, "deceleration_time",             -1, second,  0,   9990, 50),
        choice ("C14", 63, "operating_mode",                0, 3,  {2, manual}),
        setting("C15", 64, "v_f_reference_point",           -1, hertz,   250, 9990, 500),
        setting("C16", 65, "v_min_boost",                   -1, percent, 0,   400,  40),
        setting("C17", 66, "frequency_threshold",           -1, hertz,   0,   2400, 0),
        choice ("C18", 67, "chopper_frequency",             0, 3,  {2, manual}),
        setting("C21", 68, "slip_compensation",             -1, percent, 0,   400,  0),
        setting("C22", 69, "current_limit",                 0,  percent, 30,  150,  150),
        setting("C24", 70, "accel_boost",                   -1, percent, 0,   200,  0),
        choice ("C31", {absent, 71}, "analog_input_deadband", 0, 1, {0, manual}),
        choice ("C34", {71, 72}, "configuration_analog_input", 0, 4, {0, manual}),
        setting("C36", {72, 73}, "dc_injection_brake_voltage", -1, percent, 0, 500, 40),
        setting("C37", {73, 74}, "fixed_setpoint_1",        -1, hertz,   0,   9990, 200),
        setting("C38", {74, 75}, "fixed_setpoint_2",        -1, hertz,   0,   9990, 300),
        setting("C39", {75, 76}, "fixed_setpoint_3",        -1, hertz,   0,   9990, 400),
        read_out("C46", {78, 79}, "frequency_setpoint",     -1, hertz,   0,   2400),
        read_out("C50", {79, 80}, "output_frequency",       -1, hertz,   0,   2400),
        read_out("C52", {80, 82}, "motor_voltage",          0,  percent, 0,   255),
        read_out("C53", {81, 83}, "dc_bus_voltage",         0,  percent, 0,   255),
        read_out("C54", {82, 84}, "motor_current",          0,  percent, 0,   255),
        read_out("C56", {83, 85}, "drive_load",             0,  percent, 0,   255),
        number ("C59", {absent, 86}, "pi_actual_feedback",  -1, none, no_limits_unsigned, no_default, read_only),
        setting("C70", {absent, 89}, "pi_proportional_gain", -1, percent, 0,  999,  50),
        setting("C71", {absent, 90}, "pi_integral_gain",    -1, second,  0,   999,  0),
        choice ("C90", {86, 92}, "input_voltage_selection", 0, 2,  {0, manual}),
        setting("C94", {88, 94}, "user_password",           0,  none,    0,   largest_password, 0),
        word_of(text, "C99", {89, 95}, "software_version",  read_only),
        setting("c01", {absent, 96}, "accel_rate_2",        -1, second,  0,   9990, 50),
        setting("c03", {absent, 97}, "decel_rate_2",        -1, second,  0,   9990, 50),
        setting("c06", {90, 98},  "holding_time_auto_dc_injection_brake", -1, second, 0, 9990, 0),
        setting("c08", {91, 99},  "analog_output_scaling",  -1, none,    10,  9990, 1000),
        choice ("c11", {92, 100}, "configuration_analog_output",  0, 5,  {0, manual}),
        choice ("c17", {93, 101}, "configuration_digital_output", 0, 10, {0, manual}),
        setting("c20", {94, 102}, "i2t_switch_off",         0,  percent, 30,  100,  100),
        choice ("c25", {95, 103}, "lecom_baud_rate",        0, 3,  {0, manual}),
        number ("c38", {absent, 105}, "pi_actual_setpoint", -1, none, no_limits_unsigned, no_default, read_only),
        setting("c40", {97, 106}, "frequency_setpoint_command", -1, hertz, 0, 2400, 0),
        choice ("c42", {98, 107}, "start_condition",        0, 1,  {1, manual}),
        choice ("c60", {absent, 109}, "mode_select_for_c61", 0, 1, {0, manual}),
        choice ("c61", {100, 110}, "present_fault",         0, 26, no_default, read_only),
        choice ("c62", {101, 111}, "last_fault",            0, 26, no_default, read_only),
        choice ("c63", {102, 112}, "last_but_one_fault",    0, 26, no_default, read_only),
        choice ("c70", {103, 113}, "configuration_trip_reset", 0, 1, {0, manual}),
        setting("c71", {104, 114}, "auto_trip_reset_delay", -1, second,  0,   600,  0),
        counter("c78", {105, 115}, "operating_time_counter"),
        counter("c79", {106, 116}, "mains_connection_time_counter"),
        number ("c81", {absent, 117}, "pi_setpoint",        -1, none, no_limits_unsigned, {0, manual}),
        setting("c82", {absent, 118}, "s_ramp_integral_time", -1, second, 0,  500,  0),
        setting("c86", {absent, 119}, "pi_min_feedback",    -1, none,    0,   9990, 0),
        setting("c87", {absent, 120}, "pi_max_feedback",    -1, none,    0,   9990, 1000),
        setting("d25", {absent, 123}, "pi_setpoint_accel_decel", -1, second, 0, 9990, 50),
        choice ("d38", {absent, 124}, "pi_enable",          0, 2,  {0, manual}),
        setting("d46", {absent, 125}, "pi_min_alarm",       -1, none,    0,   9990, 0),
        setting("d47", {absent, 126}, "pi_max_alarm",       -1, none,    0,   9990, 0),
        choice ("n20", {113, 131}, "lecom_power_up_state",  0, 1,  {0, manual}),
        choice ("n22", {114, 132}, "serial_timeout_action", 0, 3,  {0, manual}),
        setting("n23", {115, 133}, "serial_fault_time",     -3, second,  50,  65535, 50),
    };
}();
// clang-format on

namespace detail {

template <version Version>
inline constexpr std::size_t row_count = [] {
    std::size_t count = 0;
    for (auto const& row : rows) { count += row.address_in(Version) != absent ? 1U : 0U; }
    return count;
}();

}  // namespace detail

/// The registers that one version has.
template <version Version>
inline constexpr drives::register_table<detail::row_count<Version>> table = [] {
    drives::register_table<detail::row_count<Version>> present{};
    std::size_t                                        next = 0;
    for (auto const& row : rows) {
        if (row.address_in(Version) == versioned_row::absent) { continue; }
        present[next]           = row.what;
        present[next++].address = row.address_in(Version);
    }
    return present;
}();

static_assert(strictly_ascending(table<pv400>, &drives::register_row::address));
static_assert(strictly_ascending(table<pv507>, &drives::register_row::address));

/// Where a parameter is in a version; `absent` if nowhere. For constants: at run time, a `map` finds faster.
[[nodiscard]] constexpr std::uint16_t address_of(std::string_view code, version which) noexcept
{
    for (auto const& row : rows) {
        if (row.what.code == code) { return row.address_in(which); }
    }
    return versioned_row::absent;
}

}  // namespace drivecodec::smd
