#include <drivecodec/drives/smd/table.hpp>

#include "support/verify.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace drivecodec;
using drives::access;
using drives::raw_type;
using drives::register_row;
using drives::source;

//=== section 6.2 of the manual, as it is printed ===//

struct printed_row {
    std::string_view code;
    std::string_view name;   // the manual's in lower case
    std::string_view pv400;  // decimal and hexadecimal; empty: the version lacks it
    std::string_view pv507;
    std::string_view range;  // choices with " / " between
    std::string_view factory;
};

// clang-format off
constexpr std::string_view digital_inputs =
    "1 Activate fixed setpoint 1 (JOG1) / 2 Activate fixed setpoint 2 (JOG2) / 3 DC Braking (DCB) / "
    "4 Direction of Rotation / 5 Quick Stop / 6 CW Rotation / 7 CCW Rotation / 8 UP / 9 DOWN / "
    "10 TRIP set / 11 TRIP reset / 12 Accel/decel 2 / 13 Deactivate PI / "
    "14 Activate fixed PI setpoint 1 / 15 Activate fixed PI setpoint 2";
constexpr std::string_view outputs =
    "0 Ready / 1 Fault / 2 Motor is running / 3 Motor is running - CW rotation / "
    "4 Motor is running - CCW rotation / 5 Output frequency = 0Hz / 6 Frequency setpoint reached / "
    "7 Threshold (C17) exceeded / 8 Current limit reached / 9 Feedback within min/max alarm range / "
    "10 Feedback outside min/max alarm range";

constexpr std::array<printed_row, 67> printed{{
    {"C01", "setpoint_and_control_source", "51 (33H)", "51 (33H)",
     "0 Analog / 1 c40 / 2 Analog / 3 LECOM / 4 Analog / 5 c40 / 6 Analog / 7 c40 / 8 Analog / 9 c40 / "
     "10 Analog / 11 c40", "0"},
    {"C02", "load_lenze_setting", "52 (34H)", "52 (34H)",
     "0 No action/loading complete / 1 Load 50Hz Defaults / 2 Load 60Hz Defaults / 3 Load OEM Defaults / "
     "4 Translate compatible EPM", "0"},
    {"CE1", "configuration_digital_input_e1", "53 (35H)", "53 (35H)", digital_inputs, "1"},
    {"CE2", "configuration_digital_input_e2", "54 (36H)", "54 (36H)", digital_inputs, "4"},
    {"CE3", "configuration_digital_input_e3", "55 (37H)", "55 (37H)", digital_inputs, "3"},
    {"C08", "configuration_relay_output", "57 (39H)", "57 (39H)", outputs, "1"},
    {"C09", "network_address", "58 (3AH)", "58 (3AH)", "1 - 247", "1"},
    {"C10", "minimum_output_frequency", "59 (3BH)", "59 (3BH)", "0 - 2400 (0.0 - 240 Hz)", "0.0 Hz"},
    {"C11", "maximum_output_frequency", "60 (3CH)", "60 (3CH)", "75 - 2400 (7.5 - 240 Hz)", "50.0 Hz"},
    {"C12", "acceleration_time", "61 (3DH)", "61 (3DH)", "0 - 9990 (0.0 - 999 sec)", "5.0 sec"},
    {"C13", "deceleration_time", "62 (3EH)", "62 (3EH)", "0 - 9990 (0.0 - 999 sec)", "5.0 sec"},
    {"C14", "operating_mode", "63 (3FH)", "63 (3FH)",
     "0 Linear with Auto Boost / 1 Square Law with Auto Boost / 2 Linear with Constant V_{min} Boost / "
     "3 Square Law with Constant V_{min} Boost", "2"},
    {"C15", "v_f_reference_point", "64 (40H)", "64 (40H)", "250 - 9990 (25.0 - 999 Hz)", "50.0 Hz"},
    {"C16", "v_min_boost", "65 (41H)", "65 (41H)", "0 - 400 (0.0 - 40.0%)", "4.0%"},
    {"C17", "frequency_threshold", "66 (42H)", "66 (42H)", "0 - 2400 (0.0 - 240 Hz)", "0.0 Hz"},
    {"C18", "chopper_frequency", "67 (43H)", "67 (43H)", "0 4kHz / 1 6kHz / 2 8kHz / 3 10kHz", "2"},
    {"C21", "slip_compensation", "68 (44H)", "68 (44H)", "0 - 400 (0.0 - 40.0%)", "0.0%"},
    {"C22", "current_limit", "69 (45H)", "69 (45H)", "30 - 150%", "150%"},
    {"C24", "accel_boost", "70 (46H)", "70 (46H)", "0 - 200 (0.0 - 20.0%)", "0.0%"},
    {"C31", "analog_input_deadband", "", "71 (47H)", "0 Deadband Enabled / 1 Deadband Disabled", "0"},
    {"C34", "configuration_analog_input", "71 (47H)", "72 (48H)",
     "0 0...10V / 1 0...5V / 2 0...20mA / 3 4...20mA / 4 4...20mA Monitored", "0"},
    {"C36", "dc_injection_brake_voltage", "72 (48H)", "73 (49H)", "0 - 500 (0.0 - 50.0%)", "4.0%"},
    {"C37", "fixed_setpoint_1", "73 (49H)", "74 (4AH)", "0 - 9990 (0.0 - 999)", "20.0 Hz"},
    {"C38", "fixed_setpoint_2", "74 (4AH)", "75 (4BH)", "0 - 9990 (0.0 - 999)", "30.0 Hz"},
    {"C39", "fixed_setpoint_3", "75 (4BH)", "76 (4CH)", "0 - 9990 (0.0 - 999)", "40.0 Hz"},
    {"C46", "frequency_setpoint", "78 (4EH)", "79 (4FH)", "0 - 2400 (0.0 - 240 Hz)", "Read Only"},
    {"C50", "output_frequency", "79 (4FH)", "80 (50H)", "0 - 2400 (0.0 - 240 Hz)", "Read Only"},
    {"C52", "motor_voltage", "80 (50H)", "82 (52H)", "0 - 255%", "Read Only"},
    {"C53", "dc_bus_voltage", "81 (51H)", "83 (53H)", "0 - 255%", "Read Only"},
    {"C54", "motor_current", "82 (52H)", "84 (54H)", "0 - 255%", "Read Only"},
    {"C56", "drive_load", "83 (53H)", "85 (55H)", "0 - 255%", "Read Only"},
    {"C59", "pi_actual_feedback", "", "86 (56H)", "c86 - c87", "Read Only"},
    {"C70", "pi_proportional_gain", "", "89 (59H)", "0 - 999 (0 - 99.9%)", "5.0%"},
    {"C71", "pi_integral_gain", "", "90 (5AH)", "0 - 999 (0 - 99.9 sec)", "0.0 sec"},
    {"C90", "input_voltage_selection", "86 (56H)", "92 (5CH)", "0 Auto / 1 Low / 2 High", "0"},
    {"C94", "user_password", "88 (58H)", "94 (5EH)", "0 - 999", "0"},
    {"C99", "software_version", "89 (59H)", "95 (5FH)", "Read 4 words (format 'SMD 1.51')", "Read Only"},
    {"c01", "accel_rate_2", "", "96 (60H)", "0 - 9990 (0.0 - 999 sec)", "5.0 sec"},
    {"c03", "decel_rate_2", "", "97 (61H)", "0 - 9990 (0.0 - 999 sec)", "5.0 sec"},
    {"c06", "holding_time_auto_dc_injection_brake", "90 (5AH)", "98 (62H)", "0 - 9990 (0.0 - 999 sec)", "0.0 sec"},
    {"c08", "analog_output_scaling", "91 (5BH)", "99 (63H)", "10 - 9990 (1.0 - 999)", "100.0"},
    {"c11", "configuration_analog_output", "92 (5CH)", "100 (64H)",
     "0 None / 1 Output frequency 0 - 10V / 2 Output frequency 2 - 10V / 3 Load 0 - 10V / 4 Load 2- 10V / "
     "5 Dynamic Braking", "0"},
    {"c17", "configuration_digital_output", "93 (5DH)", "101 (65H)", outputs, "0"},
    {"c20", "i2t_switch_off", "94 (5EH)", "102 (66H)", "30 - 100%", "100%"},
    {"c25", "lecom_baud_rate", "95 (5FH)", "103 (67H)",
     "0 9600, 8, N, 2 / 1 9600, 8, N, 1 / 2 9600, 8, E, 1 / 3 9600, 8, O, 1", "0"},
    {"c38", "pi_actual_setpoint", "", "105 (69H)", "c86 - c87", "Read Only"},
    {"c40", "frequency_setpoint_command", "97 (61H)", "106 (6AH)", "0 - 2400 (0.0 - 240 Hz)", "0.0 Hz"},
    {"c42", "start_condition", "98 (62H)", "107 (6BH)",
     "0 Start after LOW-HIGH change at 28 / 1 Auto Start if 28 = HIGH", "1"},
    {"c60", "mode_select_for_c61", "", "109 (6DH)", "0 Monitor Only / 1 Monitor and Edit", "0"},
    {"c61", "present_fault", "100 (64H)", "110 (6EH)", "Status / Error Message (refer to Note 5)", "Read Only"},
    {"c62", "last_fault", "101 (65H)", "111 (6FH)", "Error Message (refer to Note 5)", "Read Only"},
    {"c63", "last_but_one_fault", "102 (66H)", "112 (70H)", "Error Message (refer to Note 5)", "Read Only"},
    {"c70", "configuration_trip_reset", "103 (67H)", "113 (71H)",
     ""
     "0 TRIP reset by LOW-HIGH signal at 28 or mains switching or LOW-HIGH signal at digital input \"TRIP reset\" / "
     "1 Auto TRIP reset", "0"},
    {"c71", "auto_trip_reset_delay", "104 (68H)", "114 (72H)", "0 - 600 (0.0 - 60.0 sec)", "0.0 sec"},
    {"c78", "operating_time_counter", "105 (69H)", "115 (73H)", "", "Read Only"},
    {"c79", "mains_connection_time_counter", "106 (6AH)", "116 (74H)", "", "Read Only"},
    {"c81", "pi_setpoint", "", "117 (75H)", "c86 - c87", "0.0"},
    {"c82", "s_ramp_integral_time", "", "118 (76H)", "0 - 500 (0.0 - 50.0 sec)", "0.0 sec"},
    {"c86", "pi_min_feedback", "", "119 (77H)", "0 - 9990 (0.0 - 999.0)", "0.0"},
    {"c87", "pi_max_feedback", "", "120 (78H)", "0 - 9990 (0.0 - 999.0)", "100.0"},
    {"d25", "pi_setpoint_accel_decel", "", "123 (7BH)", "0 - 9990 (0.0 - 999.0 sec)", "5.0 sec"},
    {"d38", "pi_enable", "", "124 (7CH)",
     "0 PI Disabled / 1 PI Enabled - Normal Acting / 2 PI Enabled - Reverse Acting", "0"},
    {"d46", "pi_min_alarm", "", "125 (7DH)", "0 - 9990 (0.0 - 999.0)", "0.0"},
    {"d47", "pi_max_alarm", "", "126 (7EH)", "0 - 9990 (0.0 - 999.0)", "0.0"},
    {"n20", "lecom_power_up_state", "113 (71H)", "131 (83H)", "0 Quick Stop / 1 Inhibit", "0"},
    {"n22", "serial_timeout_action", "114 (72H)", "132 (84H)",
     "0 Not Active / 1 Controller Inhibit / 2 Quick Stop / 3 Trip Fault \"FC3\"", "0"},
    {"n23", "serial_fault_time", "115 (73H)", "133 (85H)", "50 - 65535 ms", "50 ms"},
}};
// clang-format on

/// What the printed words mean.
struct meaning {
    std::int32_t min          = 0;
    std::int32_t max          = 0xFFFF;
    bool         has_limits   = false;
    bool         is_choice    = false;
    int          exponent     = 0;
    unit         of           = unit::none;
    std::int32_t factory      = 0;
    bool         is_read_only = false;
};

unsigned address_of(std::string_view printed_address)
{
    unsigned decimal = 0;
    unsigned hex     = 0;
    if (printed_address.empty()) { return 0; }
    EXPECT_EQ(std::sscanf(std::string{printed_address}.c_str(), "%u (%xH)", &decimal, &hex), 2) << printed_address;
    EXPECT_EQ(decimal, hex) << printed_address;
    return decimal;
}

bool contains(std::string_view text, std::string_view part)
{
    return text.find(part) != std::string_view::npos;
}

meaning meaning_of_choices(std::string_view range)
{
    meaning is{.has_limits = true, .is_choice = true};
    is.min = is.max = std::atoi(range.data());
    for (auto at = range.find(" / "); at != std::string_view::npos; at = range.find(" / ", at + 3)) {
        EXPECT_EQ(std::atoi(range.data() + at + 3), ++is.max) << range;
    }
    return is;
}

meaning meaning_of(printed_row const& row)
{
    auto const range = std::string{row.range};
    meaning    is;
    if (contains(range, "refer to Note 5")) {  // table 18: 0 NO FAULT to 26 CONFIGURATION FAULT
        is = {.min = 0, .max = 26, .has_limits = true, .is_choice = true};
    } else if (contains(range, " / ")) {
        is = meaning_of_choices(range);
    } else {
        int        min = 0, max = 0;
        double     physical_min = 0, physical_max = 0;
        auto const count = std::sscanf(range.c_str(), "%d - %d (%lf - %lf", &min, &max, &physical_min, &physical_max);
        if (count >= 2) {
            is.has_limits = true;
            is.min        = min;
            is.max        = max;
        }
        auto const words = range + ' ' + std::string{row.factory};
        if (count == 4) { is.exponent = -static_cast<int>(std::lround(std::log10(max / physical_max))); }
        if (range == "c86 - c87") { is.exponent = -1; }  // theirs
        if (contains(words, " ms")) { is.exponent = -3; }
        is.of = contains(words, "Hz")                              ? unit::hertz
                : contains(words, "sec") or contains(words, " ms") ? unit::second
                : contains(words, "%")                             ? unit::percent
                                                                   : unit::none;
    }
    is.is_read_only = row.factory == "Read Only";
    if (not is.is_read_only) {
        auto const number = std::strtod(std::string{row.factory}.c_str(), nullptr);
        is.factory        = static_cast<std::int32_t>(std::lround(is.exponent == -1 ? number * 10 : number));
    }
    return is;
}

constexpr std::array both_versions{smd::pv400, smd::pv507};

std::string_view printed_in(printed_row const& row, smd::version which)
{
    return which == smd::pv400 ? row.pv400 : row.pv507;
}

register_row const* row_at(smd::version which, unsigned address)
{
    auto const wanted = static_cast<std::uint16_t>(address);
    return which == smd::pv400 ? drives::find(smd::table<smd::pv400>, wanted)
                               : drives::find(smd::table<smd::pv507>, wanted);
}

TEST(smd_table, is_the_parameter_list_of_the_manual)
{
    for (auto const which : both_versions) {
        for (auto const& wanted : printed) {
            auto const address = address_of(printed_in(wanted, which));
            if (address == 0) { continue; }
            auto const  is  = meaning_of(wanted);
            auto const* row = row_at(which, address);
            ASSERT_NE(row, nullptr) << wanted.code;
            EXPECT_EQ(row->address, address);
            EXPECT_EQ(row->code, wanted.code);
            EXPECT_EQ(row->name, wanted.name);
            EXPECT_EQ(row->is_writable(), not is.is_read_only) << wanted.code;
            EXPECT_TRUE(row->is_readable()) << wanted.code;
            EXPECT_EQ(row->limits.min, is.min) << wanted.code;
            EXPECT_EQ(row->limits.max, is.max) << wanted.code;
            EXPECT_EQ(row->limits.from, is.has_limits ? source::manual : source::nobody) << wanted.code;
            EXPECT_EQ(row->type == raw_type::enumeration, is.is_choice) << wanted.code;
            EXPECT_EQ(row->unit, is.of) << wanted.code;
            EXPECT_EQ(row->exponent, is.exponent) << wanted.code;
            EXPECT_EQ(row->factory_setting.number, is.factory) << wanted.code;
            EXPECT_EQ(row->factory_setting.from, is.is_read_only ? source::nobody : source::manual) << wanted.code;
        }
    }
}

TEST(smd_table, has_no_other_parameters)
{
    for (auto const which : both_versions) {
        std::set<unsigned> addresses;
        for (auto const& row : printed) { addresses.insert(address_of(printed_in(row, which))); }
        for (unsigned address = 51; address <= 0xFFFF; ++address) {
            ASSERT_EQ(row_at(which, address) != nullptr, addresses.contains(address)) << address;
        }
    }
    VERIFY(smd::table<smd::pv400>.size() == 15 + 51 and smd::table<smd::pv507>.size() == 15 + 67);
}

TEST(smd_table, has_numbers_without_an_entry)
{
    auto const gaps_up_to = [](smd::version which, unsigned last) {
        std::vector<unsigned> gaps;
        for (unsigned address = 51; address <= last; ++address) {
            if (row_at(which, address) == nullptr) { gaps.push_back(address); }
        }
        return gaps;
    };
    EXPECT_EQ(gaps_up_to(smd::pv400, 115),
              (std::vector<unsigned>{56, 76, 77, 84, 85, 87, 96, 99, 107, 108, 109, 110, 111, 112}));
    EXPECT_EQ(gaps_up_to(smd::pv507, 133),
              (std::vector<unsigned>{56, 77, 78, 81, 87, 88, 91, 93, 104, 108, 121, 122, 127, 128, 129, 130}));
}

//=== table 6 ===//

struct control_row {
    unsigned         address;
    unsigned         hex;
    std::string_view name;
    drives::access   may;
    std::int32_t     max;  // of those from 0 on; -1: not stated
    int              exponent;
    unit             of;
};

constexpr std::array control_registers{
    control_row{1, 0x01, "drive_control", access::write_only, 0x0200, 0, unit::none},
    control_row{19, 0x13, "drive_family", access::read_only, -1, 0, unit::none},
    control_row{21, 0x15, "drive_size", access::read_only, 0, 0, unit::none},
    control_row{22, 0x16, "drive_hardware", access::read_only, -1, 0, unit::none},
    control_row{24, 0x18, "command_speed", access::read_only, 2400, -1, unit::hertz},
    control_row{25, 0x19, "actual_speed", access::read_only, 2400, -1, unit::hertz},
    control_row{26, 0x1A, "load_and_operational_status", access::read_only, -1, 0, unit::none},
    control_row{27, 0x1B, "actual_direction_and_control_mode", access::read_only, -1, 0, unit::none},
    control_row{28, 0x1C, "speed_source_and_speed_reference", access::read_only, -1, 0, unit::none},
    control_row{29, 0x1D, "present_fault_and_commanded_direction", access::read_only, -1, 0, unit::none},
    control_row{30, 0x1E, "motor_volts", access::read_only, 250, 0, unit::percent},
    control_row{40, 0x28, "serial_speed_command", access::read_write, 2400, -1, unit::hertz},
    control_row{48, 0x30, "unlock_commands", access::write_only, 999, 0, unit::none},
    control_row{49, 0x31, "unlock_parameters", access::write_only, 999, 0, unit::none},
    control_row{50, 0x32, "register_version", access::read_only, 65535, 0, unit::none},
};

TEST(smd_table, has_the_control_registers_in_both_versions)
{
    for (auto const which : both_versions) {
        std::set<unsigned> addresses;
        for (auto const& wanted : control_registers) {
            auto const* row = row_at(which, wanted.address);
            ASSERT_NE(row, nullptr) << wanted.address;
            addresses.insert(wanted.address);
            EXPECT_EQ(wanted.hex, wanted.address);
            EXPECT_EQ(row->name, wanted.name);
            EXPECT_EQ(row->code, "");
            EXPECT_EQ(row->access, wanted.may) << wanted.name;
            EXPECT_EQ(row->limits.min, 0) << wanted.name;
            EXPECT_EQ(row->limits.max, wanted.max < 0 ? 0xFFFF : wanted.max) << wanted.name;
            EXPECT_EQ(row->limits.from, wanted.max < 0 ? source::nobody : source::manual) << wanted.name;
            EXPECT_EQ(row->exponent, wanted.exponent) << wanted.name;
            EXPECT_EQ(row->unit, wanted.of) << wanted.name;
        }
        for (unsigned address = 0; address <= 50; ++address) {
            EXPECT_EQ(row_at(which, address) != nullptr, addresses.contains(address)) << address;
        }
    }
}

TEST(smd_table, takes_one_command_at_a_time)
{
    std::set<unsigned> const commands{0x0001, 0x0002, 0x0004, 0x0008, 0x0040, 0x0080, 0x0100, 0x0200};
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        ASSERT_EQ(row_at(smd::pv507, 1)->check_write(static_cast<std::uint16_t>(raw)).ok(), commands.contains(raw));
    }
}

//=== what holds for all rows ===//

TEST(smd_table, is_in_ascending_order_in_both_versions)
{
    VERIFY(strictly_ascending(smd::table<smd::pv400>, &register_row::address));
    VERIFY(strictly_ascending(smd::table<smd::pv507>, &register_row::address));
}

TEST(smd_table, has_factory_settings_within_the_limits)
{
    for (auto const& row : smd::rows) {
        auto const& setting = row.what.factory_setting;
        EXPECT_LE(row.what.limits.min, row.what.limits.max);
        if (setting.from == source::manual) { EXPECT_TRUE(row.what.check(setting.number).ok()) << row.what.code; }
    }
}

TEST(smd_table, has_every_code_and_name_once)
{
    std::set<std::string_view> words;
    for (auto const& row : smd::rows) {
        EXPECT_TRUE(words.insert(row.what.name).second) << row.what.name;
        if (not row.what.code.empty()) { EXPECT_TRUE(words.insert(row.what.code).second) << row.what.code; }
    }
}

TEST(smd_table, takes_what_is_within_the_limits_and_nothing_else)
{
    for (auto const& row : smd::table<smd::pv507>) {
        if (row.address < 51) { continue; }
        for (std::int32_t raw = 0; raw <= 0xFFFF; ++raw) {
            auto const fits = raw >= row.limits.min and raw <= row.limits.max;
            ASSERT_EQ(row.check_write(static_cast<std::uint16_t>(raw)).ok(), fits and row.is_writable()) << row.code;
        }
    }
}

TEST(smd_table, says_where_a_code_is)
{
    for (auto const& row : printed) {
        EXPECT_EQ(smd::address_of(row.code, smd::pv400), address_of(row.pv400));
        EXPECT_EQ(smd::address_of(row.code, smd::pv507), address_of(row.pv507));
    }
    VERIFY(smd::address_of("C40", smd::pv507) == smd::versioned_row::absent);  // it is c40
}

//=== where the manual is to be read twice ===//

TEST(smd_manual, means_different_parameters_by_the_same_number_from_71_up)
{
    for (unsigned address = 1; address <= 70; ++address) {
        auto const* row = row_at(smd::pv400, address);
        ASSERT_EQ(row == nullptr, row_at(smd::pv507, address) == nullptr) << address;
        if (row != nullptr) { EXPECT_EQ(row->name, row_at(smd::pv507, address)->name) << address; }
    }
    for (unsigned address = 71; address <= 133; ++address) {
        auto const* row   = row_at(smd::pv400, address);
        auto const* other = row_at(smd::pv507, address);
        if (row != nullptr and other != nullptr) { EXPECT_NE(row->code, other->code) << address; }
    }
    EXPECT_EQ(row_at(smd::pv400, 71)->code, "C34");
    EXPECT_EQ(row_at(smd::pv507, 71)->code, "C31");
    EXPECT_EQ(row_at(smd::pv400, 95)->code, "c25");
    EXPECT_EQ(row_at(smd::pv507, 95)->code, "C99");
}

TEST(smd_manual, prints_minimum_output_frequency_twice_of_which_C11_is_the_maximum)
{
    EXPECT_EQ(row_at(smd::pv507, 59)->name, "minimum_output_frequency");
    EXPECT_EQ(row_at(smd::pv507, 60)->name, "maximum_output_frequency");
}

TEST(smd_manual, calls_register_40_keypad_speed_and_serial_speed)
{
    EXPECT_EQ(row_at(smd::pv400, 40)->name, "serial_speed_command");
}

TEST(smd_manual, limits_motor_volts_to_250_and_motor_voltage_to_255)
{
    EXPECT_EQ(row_at(smd::pv507, 30)->limits.max, 250);
    EXPECT_EQ(row_at(smd::pv507, 82)->limits.max, 255);
    EXPECT_EQ(row_at(smd::pv507, 30)->number(255), 255);  // as it is read
}

TEST(smd_manual, lets_fixed_setpoints_go_up_to_999_where_frequencies_end_at_240)
{
    for (unsigned address = 74; address <= 76; ++address) {
        EXPECT_EQ(row_at(smd::pv507, address)->limits.max, 9990);
        EXPECT_EQ(row_at(smd::pv507, address)->unit, unit::hertz);
    }
    EXPECT_EQ(row_at(smd::pv507, 40)->limits.max, 2400);
}

TEST(smd_manual, counts_control_registers_from_0_but_describes_none_of_that_number)
{
    EXPECT_EQ(row_at(smd::pv400, 0), nullptr);
    EXPECT_EQ(row_at(smd::pv507, 0), nullptr);
}

TEST(smd_manual, has_limits_that_c86_and_c87_set)
{
    for (auto const address : std::array{86U, 105U, 117U}) {  // C59, c38, c81
        EXPECT_EQ(row_at(smd::pv507, address)->limits.from, source::nobody);
        EXPECT_EQ(row_at(smd::pv507, address)->exponent, row_at(smd::pv507, 119)->exponent);
    }
}

TEST(smd_manual, has_counters_without_unit_and_range)
{
    for (auto const address : std::array{115U, 116U}) {
        EXPECT_EQ(row_at(smd::pv507, address)->scale_from, source::nobody);
        EXPECT_EQ(row_at(smd::pv507, address)->limits.from, source::nobody);
    }
}

TEST(smd_manual, has_selections_of_PV507_in_bold_which_is_lost_so_that_PV400_takes_them_too)
{
    EXPECT_TRUE(row_at(smd::pv400, 53)->check_write(15).ok());
    EXPECT_TRUE(row_at(smd::pv400, 57)->check_write(10).ok());
}

TEST(smd_manual, says_that_c61_shows_texts_which_have_no_code)
{
    EXPECT_EQ(row_at(smd::pv507, 110)->limits.max, 26);
    EXPECT_EQ(row_at(smd::pv507, 110)->number(27), 27);
}

TEST(smd_manual, has_no_signed_values)
{
    for (auto const& row : smd::rows) { EXPECT_EQ(row.what.number(0xFFFF), 0xFFFF) << row.what.name; }
}

TEST(smd_manual, loads_defaults_in_off_or_inhibit_only)
{
    EXPECT_EQ(row_at(smd::pv507, 52)->access, access::read_write_at_standstill);
}

}  // namespace
