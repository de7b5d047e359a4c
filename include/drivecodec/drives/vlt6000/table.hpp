// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/table.hpp>
#include <drivecodec/drives/vlt6000/bus_time_out.hpp>
#include <drivecodec/drives/vlt6000/choices.hpp>
#include <drivecodec/drives/vlt6000/gating.hpp>
#include <drivecodec/drives/vlt6000/parameter_row.hpp>

namespace drivecodec::vlt6000 {

namespace detail {

using fc::width;
using enum drives::access;

[[nodiscard]] consteval value_limits from_to(int min, int max)
{
    return {{min, 0}, {max, 0}};
}

/// The manual has no more of it than the number, most often the name, and what the sentences around it tell.
[[nodiscard]] consteval parameter_row named(int number, std::string_view name, kind what = {})
{
    return {.number = static_cast<std::uint16_t>(number), .name = name, .kind = what};
}

/// One of the texts of the name plate: read only, as all of data type 9.
[[nodiscard]] consteval parameter_row name_plate(int number, std::string_view name = "nameplate_data")
{
    return {.number    = static_cast<std::uint16_t>(number),
            .name      = name,
            .kind      = kind::text,
            .access    = read_only,
            .data_type = fc::data_type::text_string};
}

/// A choice of which all numbers are printed.
template <typename Code>
[[nodiscard]] consteval parameter_row choice_of(std::span<std::uint16_t const> codes, int number, std::string_view name,
                                                std::string_view display_text, Code factory_setting,
                                                access may = read_write)
{
    return {.number          = static_cast<std::uint16_t>(number),
            .name            = name,
            .display_text    = display_text,
            .kind            = kind::choice,
            .access          = may,
            .factory_setting = decimal{static_cast<std::int32_t>(factory_setting), 0},
            .choices         = codes};
}

/// Of "509 - 532 Data read-out". `prefix` is that of the unit, `unit_from` the parameter in which it is selected.
[[nodiscard]] consteval parameter_row read_out(int number, std::string_view name, std::string_view display_text,
                                               unit of, int update_interval, int prefix = 0, int unit_from = 0)
{
    return {.number           = static_cast<std::uint16_t>(number),
            .name             = name,
            .display_text     = display_text,
            .kind             = kind::number,
            .access           = read_only,
            .unit             = of,
            .unit_prefix      = static_cast<std::int8_t>(prefix),
            .unit_selected_in = static_cast<std::uint16_t>(unit_from),
            .update_interval  = static_cast<std::uint16_t>(update_interval)};
}

[[nodiscard]] consteval parameter_row read_out_of_bits(int number, std::string_view name, std::string_view display_text,
                                                       int update_interval, stated<fc::width> size = {})
{
    return {.number          = static_cast<std::uint16_t>(number),
            .name            = name,
            .display_text    = display_text,
            .kind            = kind::bits,
            .access          = read_only,
            .width           = size,
            .update_interval = static_cast<std::uint16_t>(update_interval)};
}

/// What is there to be written over the line.
[[nodiscard]] consteval parameter_row display_line(int number, std::string_view name, std::string_view display_text,
                                                   int max_length)
{
    return {.number          = static_cast<std::uint16_t>(number),
            .name            = name,
            .display_text    = display_text,
            .kind            = kind::text,
            .access          = write_only,
            .max_text_length = static_cast<std::uint8_t>(max_length)};
}

[[nodiscard]] consteval parameter_row bus_feedback(int number, std::string_view name, std::string_view display_text)
{
    return {.number          = static_cast<std::uint16_t>(number),
            .name            = name,
            .display_text    = display_text,
            .kind            = kind::number,
            .access          = write_only,
            .limits          = from_to(0, 0x4000),
            .factory_setting = decimal{0, 0}};
}

}  // namespace detail

/// Every parameter that the manual names, as it prints it. VLT 6000 manual, "Serial communication 500 - 536" and, for
/// the numbers outside of that group, wherever they occur.
///
/// Data types, widths and conversion indexes are in the guide's section on factory settings, which this is not from:
/// they are known only where an example or a sentence of the chapter shows them. Alarm, warning and extended status word
/// have 32 bits, which only a double word holds; status and control word would fit into either.
///
/// Worth a second look: the read-out of the control word is printed with 2 ms among neighbours with 20. The address has
/// its limits under the FC protocol; for the others see `address_limits_of`. Bus feedbacks are printed in hexadecimal
/// too, 0 to 4000, as if they were transferred as they are; the manual does not say so.
// clang-format off
inline constexpr std::array<parameter_row, 87> table = [] {
    using namespace detail;
    using vlt6000::kind::choice;
    using vlt6000::kind::number;
    constexpr gating_settings factory{};
    return std::array{
        parameter_row{.number = 1, .name = "language", .kind = choice, .access = read_write,
                      .choices = language_codes, .has_other_choices = true},
        named(2, "active_setup"),
        named(4, "", choice),  // one is Multi-setups
        named(5, "max_value_of_user_defined_read_out", number),
        named(6, "unit_for_user_defined_read_out", choice),
        parameter_row{.number = 7, .name = "large_display_read_out", .kind = choice,
                      .choices = large_display_read_out_codes, .has_other_choices = true},
        named(8, "display_read_out"),
        named(9, "display_read_out"),
        named(10, "display_read_out"),
        named(100, "", choice),  // Open loop or Closed loop
        named(102, ""),          // 102 to 106: those to check after an automatic motor adaptation
        named(103, ""),
        named(104, ""),
        named(105, ""),
        named(106, ""),
        named(114, "dc_braking_current", number),
        named(115, "dc_braking_time", number),
        named(117, "motor_thermal_protection"),
        parameter_row{.number = 201, .name = "output_frequency_low_limit", .kind = number, .access = read_write,
                      .conversion_index = -1, .unit = unit::hertz},
        parameter_row{.number = 202, .name = "output_frequency_high_limit", .kind = number, .access = read_write,
                      .width = width::word, .conversion_index = -1, .unit = unit::hertz},
        named(204, "minimum_reference", number),
        named(205, "maximum_reference", number),
        parameter_row{.number = 206, .name = "ramp_up_time", .kind = number,
                      .width = width::word, .conversion_index = 0, .unit = unit::second},
        named(207, "ramp_down_time", number),
        named(209, "jog_frequency", number),
        named(211, "preset_reference_1", number),
        named(212, "preset_reference_2", number),
        named(213, "preset_reference_3", number),
        named(214, "preset_reference_4", number),
        named(215, "current_limit", number),
        named(323, "relay_outputs", choice),  // of both, one is Control word bits 11/12
        named(326, "relay_outputs", choice),
        named(412, "trip_delay_overcurrent", number),
        named(413, ""),  // 413 and 414, with 415: unit and scaling of the feedback
        named(414, ""),
        parameter_row{.number = 415, .name = "process_units", .kind = choice, .access = read_write,
                      .width = width::word, .choices = process_unit_codes, .has_other_choices = true},

        choice_of(protocol_codes, 500, "protocol", "PROTOCOL", protocol::fc_protocol),
        parameter_row{.number = 501, .name = "address", .display_text = "ADDRESS", .kind = number,
                      .access = panel_only, .limits = from_to(0, 126), .factory_setting = decimal{1, 0}},
        choice_of(baud_rate_codes, 502, "baudrate", "BAUDRATE", baud_rate::baud_9600, panel_only),
        choice_of(gating_codes, 503, "coasting_stop",                 "COASTING",            factory.coasting_stop),
        choice_of(gating_codes, 504, "dc_brake",                      "DC BRAKE",            factory.dc_brake),
        choice_of(gating_codes, 505, "start",                         "START",               factory.start),
        choice_of(gating_codes, 506, "reversing",                     "REVERSING",           factory.reversing),
        choice_of(gating_codes, 507, "selection_of_setup",            "SELECTING OF SETUP",  factory.setup),
        choice_of(gating_codes, 508, "selection_of_preset_reference", "SELECTING OF SPEED",  factory.preset_reference),
        read_out(509, "resulting_reference",         "REFERENCE %",                unit::percent,    80),
        read_out(510, "resulting_reference_in_unit", "REFERENCE [UNIT]",           unit::none,       80, 0, 415),
        read_out(511, "feedback",                    "FEEDBACK",                   unit::none,       80, 0, 415),
        read_out(512, "frequency",                   "FREQUENCY",                  unit::hertz,      80),
        read_out(513, "user_defined_read_out",       "CUSTOM READOUT",             unit::none,       80, 0, 6),
        read_out(514, "motor_current",               "CURRENT",                    unit::ampere,     80),
        read_out(515, "power_in_kw",                 "POWER KW",                   unit::watt,       80, 3),
        read_out(516, "power_in_hp",                 "POWER HK",                   unit::horsepower, 80),
        read_out(517, "motor_voltage",               "MOTOR VOLT",                 unit::volt,       80),
        read_out(518, "dc_link_voltage",             "DC LINK VOLTAGE",            unit::volt,       80),
        read_out(519, "thermal_load_motor",          "MOTOR TEMPERATURE",          unit::percent,    80),
        read_out(520, "thermal_load_vlt",            "VLT TEMPERATURE",            unit::percent,    80),
        read_out_of_bits(521, "digital_input",       "DIGITAL INPUT",               80),
        read_out(522, "terminal_53_analog_input",    "TERMINAL 53, ANALOG INPUT",  unit::volt,       20),
        read_out(523, "terminal_54_analog_input",    "TERMINAL 54, ANALOG INPUT",  unit::volt,       20),
        read_out(524, "terminal_60_analog_input",    "TERMINAL 60, ANALOG INPUT",  unit::ampere,     20, -3),
        read_out(525, "pulse_reference",             "PULSE REFERENCE",            unit::hertz,      20),
        read_out(526, "external_reference",          "EXTERNAL REFERENCE",         unit::percent,    20),
        read_out_of_bits(527, "status_word",         "STATUS WORD HEX",             20),
        read_out(528, "heat_sink_temperature",       "HEAT SINK TEMP.",            unit::degree_celsius, 1200),
        read_out_of_bits(529, "alarm_word",           "ALARM WORD, HEX",            20, width::double_word),
        read_out_of_bits(530, "control_word",         "VLT CONTROL WORD, HEX",      2),
        read_out_of_bits(531, "warning_word",         "WARNING WORD",               20, width::double_word),
        read_out_of_bits(532, "extended_status_word", "STATUS WORD",                20, width::double_word),
        display_line(533, "display_text_1", "DISPLAY TEXT ARRAY 1", 8),
        display_line(534, "display_text_2", "DISPLAY TEXT ARRAY 2", 20),
        bus_feedback(535, "bus_feedback_1", "BUS FEEDBACK1"),
        bus_feedback(536, "bus_feedback_2", "BUS FEEDBACK 2"),
        parameter_row{.number = 555, .name = "bus_time_interval", .display_text = "BUS TIME INTERVAL", .kind = number,
                      .access = read_write, .unit = unit::second,
                      .limits = value_limits{shortest_bus_time_interval.value(), longest_bus_time_interval.value()},
                      .factory_setting = factory_bus_time_interval.value()},
        choice_of(bus_time_interval_function_codes, 556, "bus_time_interval_function", "BUS TIME INTERVAL FUNCTION",
                  factory_bus_time_interval_function),

        parameter_row{.number = 615, .name = "error_code", .kind = number, .is_array = true, .limits = from_to(1, 99)},
        name_plate(621, "unit_type"),
        name_plate(622),
        name_plate(623),
        name_plate(624),
        name_plate(625),
        name_plate(626),
        name_plate(627),
        name_plate(628),
        name_plate(629),
        name_plate(630),
        name_plate(631),
    };
}();
// clang-format on

static_assert(strictly_ascending(table, &parameter_row::number));

/// The parameter with this number, or nullptr.
[[nodiscard]] constexpr parameter_row const* find(std::uint16_t number) noexcept
{
    return find_row(table, &parameter_row::number, number);
}

/// The one parameter with this name ("ramp_up_time") or display text ("BUS FEEDBACK 2"), or nullptr: also for a name
/// that several have, as nameplate_data.
[[nodiscard]] constexpr parameter_row const* find(std::string_view word) noexcept
{
    return find_word(table, word, &parameter_row::name, &parameter_row::display_text);
}

}  // namespace drivecodec::vlt6000
