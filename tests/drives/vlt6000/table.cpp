#include <drivecodec/drives/vlt6000/choices.hpp>
#include <drivecodec/drives/vlt6000/table.hpp>

#include "support/verify.hpp"

#include <array>
#include <set>
#include <string_view>

namespace {

using namespace drivecodec;
using vlt6000::access;
using vlt6000::find;
using vlt6000::kind;

std::set<unsigned> range(unsigned first, unsigned last)
{
    std::set<unsigned> numbers;
    for (auto number = first; number <= last; ++number) { numbers.insert(number); }
    return numbers;
}

//=== which there are ===//

TEST(vlt6000_table, has_every_parameter_that_the_manual_names_and_no_other)
{
    std::set<unsigned> expected{1, 2, 100, 114, 115, 117, 201, 202, 209, 323, 326, 555, 556, 615};
    expected.merge(range(4, 10));
    expected.merge(range(102, 106));  // the warning word: "check par. 102, 103, 105" and "102, 104, 106"
    expected.merge(range(204, 207));
    expected.merge(range(211, 215));
    expected.merge(range(412, 415));
    expected.merge(range(500, 536));
    expected.merge(range(621, 631));

    std::set<unsigned> found;
    for (auto const& row : vlt6000::table) { found.insert(row.number); }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(vlt6000::table.size(), expected.size());

    for (unsigned number = 0; number <= 0xFFFF; ++number) {
        auto const* row = find(static_cast<std::uint16_t>(number));
        ASSERT_EQ(row != nullptr, expected.contains(number)) << number;
        if (row != nullptr) { ASSERT_EQ(row->number, number); }
    }
}

struct printed_text {
    unsigned         number;
    std::string_view name;
    std::string_view display;
};
constexpr std::array printed_texts{
    printed_text{500, "protocol", "PROTOCOL"},
    printed_text{501, "address", "ADDRESS"},
    printed_text{502, "baudrate", "BAUDRATE"},
    printed_text{503, "coasting_stop", "COASTING"},
    printed_text{504, "dc_brake", "DC BRAKE"},
    printed_text{505, "start", "START"},
    printed_text{506, "reversing", "REVERSING"},
    printed_text{507, "selection_of_setup", "SELECTING OF SETUP"},
    printed_text{508, "selection_of_preset_reference", "SELECTING OF SPEED"},
    printed_text{509, "resulting_reference", "REFERENCE %"},
    printed_text{510, "resulting_reference_in_unit", "REFERENCE [UNIT]"},
    printed_text{511, "feedback", "FEEDBACK"},
    printed_text{512, "frequency", "FREQUENCY"},
    printed_text{513, "user_defined_read_out", "CUSTOM READOUT"},
    printed_text{514, "motor_current", "CURRENT"},
    printed_text{515, "power_in_kw", "POWER KW"},
    printed_text{516, "power_in_hp", "POWER HK"},
    printed_text{517, "motor_voltage", "MOTOR VOLT"},
    printed_text{518, "dc_link_voltage", "DC LINK VOLTAGE"},
    printed_text{519, "thermal_load_motor", "MOTOR TEMPERATURE"},
    printed_text{520, "thermal_load_vlt", "VLT TEMPERATURE"},
    printed_text{521, "digital_input", "DIGITAL INPUT"},
    printed_text{522, "terminal_53_analog_input", "TERMINAL 53, ANALOG INPUT"},
    printed_text{523, "terminal_54_analog_input", "TERMINAL 54, ANALOG INPUT"},
    printed_text{524, "terminal_60_analog_input", "TERMINAL 60, ANALOG INPUT"},
    printed_text{525, "pulse_reference", "PULSE REFERENCE"},
    printed_text{526, "external_reference", "EXTERNAL REFERENCE"},
    printed_text{527, "status_word", "STATUS WORD HEX"},
    printed_text{528, "heat_sink_temperature", "HEAT SINK TEMP."},
    printed_text{529, "alarm_word", "ALARM WORD, HEX"},
    printed_text{530, "control_word", "VLT CONTROL WORD, HEX"},
    printed_text{531, "warning_word", "WARNING WORD"},
    printed_text{532, "extended_status_word", "STATUS WORD"},
    printed_text{533, "display_text_1", "DISPLAY TEXT ARRAY 1"},
    printed_text{534, "display_text_2", "DISPLAY TEXT ARRAY 2"},
    printed_text{535, "bus_feedback_1", "BUS FEEDBACK1"},
    printed_text{536, "bus_feedback_2", "BUS FEEDBACK 2"},
    printed_text{555, "bus_time_interval", "BUS TIME INTERVAL"},
    printed_text{556, "bus_time_interval_function", "BUS TIME INTERVAL FUNCTION"},
};

TEST(vlt6000_table, has_the_serial_parameters_as_printed)
{
    for (auto const& wanted : printed_texts) {
        auto const* row = find(static_cast<std::uint16_t>(wanted.number));
        ASSERT_NE(row, nullptr) << wanted.number;
        EXPECT_EQ(row->name, wanted.name);
        EXPECT_EQ(row->display_text, wanted.display);
        EXPECT_EQ(find(wanted.name), row) << wanted.name;
        EXPECT_EQ(find(wanted.display), row) << wanted.display;
    }
    for (auto const& row : vlt6000::table) {
        EXPECT_EQ(row.display_text.empty(), row.number < 500 or row.number > 556) << row.number;
    }
}

TEST(vlt6000_table, has_the_others_by_the_names_that_sentences_give_them)
{
    constexpr std::array named{
        printed_text{1, "language", {}},
        printed_text{2, "active_setup", {}},
        printed_text{4, "", {}},
        printed_text{5, "max_value_of_user_defined_read_out", {}},
        printed_text{6, "unit_for_user_defined_read_out", {}},
        printed_text{7, "large_display_read_out", {}},
        printed_text{8, "display_read_out", {}},
        printed_text{9, "display_read_out", {}},
        printed_text{10, "display_read_out", {}},
        printed_text{100, "", {}},
        printed_text{102, "", {}},
        printed_text{103, "", {}},
        printed_text{104, "", {}},
        printed_text{105, "", {}},
        printed_text{106, "", {}},
        printed_text{114, "dc_braking_current", {}},
        printed_text{115, "dc_braking_time", {}},
        printed_text{117, "motor_thermal_protection", {}},
        printed_text{201, "output_frequency_low_limit", {}},
        printed_text{202, "output_frequency_high_limit", {}},
        printed_text{204, "minimum_reference", {}},
        printed_text{205, "maximum_reference", {}},
        printed_text{206, "ramp_up_time", {}},
        printed_text{207, "ramp_down_time", {}},
        printed_text{209, "jog_frequency", {}},
        printed_text{211, "preset_reference_1", {}},
        printed_text{212, "preset_reference_2", {}},
        printed_text{213, "preset_reference_3", {}},
        printed_text{214, "preset_reference_4", {}},
        printed_text{215, "current_limit", {}},
        printed_text{323, "relay_outputs", {}},
        printed_text{326, "relay_outputs", {}},
        printed_text{412, "trip_delay_overcurrent", {}},
        printed_text{413, "", {}},
        printed_text{414, "", {}},
        printed_text{415, "process_units", {}},
        printed_text{615, "error_code", {}},
        printed_text{621, "unit_type", {}},
    };
    for (auto const& wanted : named) {
        EXPECT_EQ(find(static_cast<std::uint16_t>(wanted.number))->name, wanted.name) << wanted.number;
    }
    for (auto number = 622U; number <= 631; ++number) {
        EXPECT_EQ(find(static_cast<std::uint16_t>(number))->name, "nameplate_data");
    }
    EXPECT_EQ(named.size() + printed_texts.size() + 10, vlt6000::table.size());
}

TEST(vlt6000_table, is_searched_by_a_word_that_only_one_has)
{
    VERIFY(find("ramp_up_time")->number == 206 and find("BUS FEEDBACK 2")->number == 536);
    VERIFY(find("STATUS WORD")->number == 532 and find("status_word")->number == 527);
    VERIFY(find("relay_outputs") == nullptr and find("nameplate_data") == nullptr
           and find("display_read_out") == nullptr);
    VERIFY(find("") == nullptr and find("Protocol") == nullptr and find("PROTOCO") == nullptr
           and find("500") == nullptr);
    for (auto const& row : vlt6000::table) {
        auto count = 0;
        for (auto const& other : vlt6000::table) { count += other.name == row.name ? 1 : 0; }
        EXPECT_EQ(find(row.name), row.name.empty() or count > 1 ? nullptr : &row) << row.name;
    }
}

//=== read-outs ===//

struct printed_read_out {
    unsigned number;
    unit     of;
    int      prefix;
    int      interval;  // milliseconds
};
constexpr std::array read_outs{
    printed_read_out{509, unit::percent, 0, 80}, printed_read_out{510, unit::none, 0, 80},
    printed_read_out{511, unit::none, 0, 80},    printed_read_out{512, unit::hertz, 0, 80},
    printed_read_out{513, unit::none, 0, 80},    printed_read_out{514, unit::ampere, 0, 80},
    printed_read_out{515, unit::watt, 3, 80},    printed_read_out{516, unit::horsepower, 0, 80},
    printed_read_out{517, unit::volt, 0, 80},    printed_read_out{518, unit::volt, 0, 80},
    printed_read_out{519, unit::percent, 0, 80}, printed_read_out{520, unit::percent, 0, 80},
    printed_read_out{521, unit::none, 0, 80},    printed_read_out{522, unit::volt, 0, 20},
    printed_read_out{523, unit::volt, 0, 20},    printed_read_out{524, unit::ampere, -3, 20},
    printed_read_out{525, unit::hertz, 0, 20},   printed_read_out{526, unit::percent, 0, 20},
    printed_read_out{527, unit::none, 0, 20},    printed_read_out{528, unit::degree_celsius, 0, 1200},
    printed_read_out{529, unit::none, 0, 20},    printed_read_out{530, unit::none, 0, 2},
    printed_read_out{531, unit::none, 0, 20},    printed_read_out{532, unit::none, 0, 20},
};

TEST(vlt6000_table, has_units_and_intervals_of_the_read_outs)
{
    ASSERT_EQ(read_outs.size(), 532 - 509 + 1);
    for (auto const& wanted : read_outs) {
        auto const& row = *find(static_cast<std::uint16_t>(wanted.number));
        EXPECT_EQ(row.unit, wanted.of) << wanted.number;
        EXPECT_EQ(row.unit_prefix, wanted.prefix) << wanted.number;
        EXPECT_EQ(row.update_interval, wanted.interval) << wanted.number;
        EXPECT_EQ(row.access, access::read_only) << wanted.number;
        EXPECT_EQ(row.check_write(), (error{errc::read_only, 0})) << wanted.number;
        EXPECT_FALSE(row.limits or row.factory_setting or row.conversion_index or row.data_type) << wanted.number;

        auto const is_bits = std::set<unsigned>{521, 527, 529, 530, 531, 532}.contains(wanted.number);
        EXPECT_EQ(row.kind, is_bits ? kind::bits : kind::number) << wanted.number;
    }
    for (auto const& row : vlt6000::table) {
        EXPECT_EQ(row.update_interval > 0, row.number >= 509 and row.number <= 532) << row.number;
    }
}

TEST(vlt6000_table, knows_where_a_unit_is_selected)
{
    VERIFY(find(510)->unit_selected_in == 415 and find(511)->unit_selected_in == 415);
    VERIFY(find(513)->unit_selected_in == 6);
    for (auto const& row : vlt6000::table) {
        auto const depends = row.number == 510 or row.number == 511 or row.number == 513;
        EXPECT_EQ(row.unit_selected_in != 0, depends) << row.number;
        if (depends) { EXPECT_EQ(row.unit, unit::none); }
    }
}

TEST(vlt6000_table, has_units_elsewhere_only_where_an_example_or_a_range_prints_one)
{
    for (auto const& row : vlt6000::table) {
        if (row.number >= 509 and row.number <= 532) { continue; }
        auto const expected = row.number == 201 or row.number == 202   ? unit::hertz
                              : row.number == 206 or row.number == 555 ? unit::second
                                                                       : unit::none;
        EXPECT_EQ(row.unit, expected) << row.number;
        EXPECT_EQ(row.unit_prefix, 0) << row.number;
    }
}

//=== on the line ===//

TEST(vlt6000_table, knows_conversion_indexes_of_three_parameters)
{
    VERIFY(*find(201)->conversion_index == -1 and *find(202)->conversion_index == -1);
    VERIFY(*find(206)->conversion_index == 0);
    for (auto const& row : vlt6000::table) {
        EXPECT_EQ(row.conversion_index.is_known, row.number == 201 or row.number == 202 or row.number == 206)
            << row.number;
    }
}

TEST(vlt6000_table, knows_widths_of_what_the_examples_transfer_and_of_words_of_32_bits)
{
    std::set<unsigned> const words{202, 206, 415};         // E0CA, the reply 10CE, E19F
    std::set<unsigned> const double_words{529, 531, 532};  // codes up to 80000000
    for (auto const& row : vlt6000::table) {
        EXPECT_EQ(row.width == fc::width::word, words.contains(row.number)) << row.number;
        EXPECT_EQ(row.width == fc::width::double_word, double_words.contains(row.number)) << row.number;
        EXPECT_EQ(row.width.is_known, words.contains(row.number) or double_words.contains(row.number)) << row.number;
    }
}

TEST(vlt6000_table, knows_the_data_type_of_the_name_plate_only)
{
    for (auto const& row : vlt6000::table) {
        auto const is_name_plate = row.number >= 621 and row.number <= 631;
        EXPECT_EQ(row.data_type.is_known, is_name_plate) << row.number;
        if (not is_name_plate) { continue; }
        EXPECT_EQ(static_cast<int>(*row.data_type), 9) << row.number;
        EXPECT_EQ(row.kind, kind::text) << row.number;
        EXPECT_EQ(row.access, access::read_only) << row.number;
    }
}

TEST(vlt6000_table, has_one_array)
{
    for (auto const& row : vlt6000::table) { EXPECT_EQ(row.is_array, row.number == 615) << row.number; }
    VERIFY(find(615)->check({1, 0}).ok() and find(615)->check({99, 0}).ok());
    VERIFY(not find(615)->check({0, 0}).ok() and not find(615)->check({100, 0}).ok());
}

TEST(vlt6000_table, claims_access_only_where_the_manual_does)
{
    std::set<unsigned> read_only{range(509, 532)};
    read_only.merge(range(621, 631));
    std::set<unsigned> read_write{1, 201, 202, 415, 500, 555, 556};
    read_write.merge(range(503, 508));
    for (auto const& row : vlt6000::table) {
        auto const expected = read_only.contains(row.number)            ? access::read_only
                              : read_write.contains(row.number)         ? access::read_write
                              : row.number == 501 or row.number == 502  ? access::panel_only
                              : row.number >= 533 and row.number <= 536 ? access::write_only
                                                                        : access::unknown;
        EXPECT_EQ(row.access, expected) << row.number;
    }
}

//=== values ===//

TEST(vlt6000_table, has_the_worked_examples)
{
    VERIFY(find(0xE0CA & 0x7FF) == find("output_frequency_high_limit"));
    VERIFY(find(202)->value(0x03E8) == decimal{100, 0});
    VERIFY(find(201)->value(100) == decimal{10, 0} and find(201)->value(100).exponent == -1);  // 10.0
    VERIFY(find(0x119F & 0x7FF) == find("process_units"));
    VERIFY(find(0x1267 & 0x7FF) == find("error_code"));
}

struct printed_default {
    unsigned number;
    int      star;  // behind the asterisk
};

TEST(vlt6000_table, has_the_factory_settings_that_are_printed)
{
    constexpr std::array stars{
        printed_default{500, 0}, printed_default{501, 1}, printed_default{502, 5}, printed_default{503, 3},
        printed_default{504, 3}, printed_default{505, 3}, printed_default{506, 0}, printed_default{507, 3},
        printed_default{508, 3}, printed_default{535, 0}, printed_default{536, 0}, printed_default{555, 1},
        printed_default{556, 0},
    };
    auto count = std::size_t{0};
    for (auto const& row : vlt6000::table) {
        if (not row.factory_setting) { continue; }
        ++count;
        EXPECT_TRUE(row.check(*row.factory_setting).ok()) << row.number;
    }
    EXPECT_EQ(count, stars.size());
    for (auto const& wanted : stars) {
        auto const& row = *find(static_cast<std::uint16_t>(wanted.number));
        EXPECT_EQ(row.factory_setting, (vlt6000::stated<decimal>{decimal{wanted.star, 0}})) << wanted.number;
    }
}

TEST(vlt6000_table, has_the_ranges_that_are_printed)
{
    VERIFY(*find(501)->limits == vlt6000::value_limits{{0, 0}, {126, 0}});
    VERIFY(*find(535)->limits == vlt6000::value_limits{{0, 0}, {16384, 0}});
    VERIFY(*find(536)->limits == *find(535)->limits);
    VERIFY(*find(555)->limits == vlt6000::value_limits{{1, 0}, {65534, 0}});
    VERIFY(*find(615)->limits == vlt6000::value_limits{{1, 0}, {99, 0}});
    for (auto const& row : vlt6000::table) {
        EXPECT_EQ(row.limits.is_known, (std::set<unsigned>{501, 535, 536, 555, 615}.contains(row.number)))
            << row.number;
    }
    VERIFY(find(501)->limits.value.max == decimal{vlt6000::address_limits_of(vlt6000::protocol{0})->max, 0});
}

TEST(vlt6000_table, has_choices_from_0_on)
{
    std::set<unsigned> with_choices{1, 7, 415, 500, 502, 556};
    with_choices.merge(range(503, 508));
    for (auto const& row : vlt6000::table) {
        EXPECT_EQ(not row.choices.empty(), with_choices.contains(row.number)) << row.number;
        if (row.choices.empty()) { continue; }
        EXPECT_EQ(row.kind, kind::choice) << row.number;
        EXPECT_EQ(row.has_other_choices, row.number < 500) << row.number;
    }
    for (unsigned code = 0; code <= 0xFFFF; ++code) {
        auto const value = decimal{static_cast<std::int32_t>(code), 0};
        ASSERT_EQ(find(500)->check(value).ok(), code <= 2) << code;
        ASSERT_EQ(find(502)->check(value).ok(), code <= 5) << code;
        ASSERT_EQ(find(503)->check(value).ok(), code <= 3) << code;
        ASSERT_EQ(find(508)->check(value).ok(), code <= 3) << code;
        ASSERT_EQ(find(556)->check(value).ok(), code <= 5) << code;
        ASSERT_TRUE(find(1)->check(value).ok() and find(415)->check(value).ok()) << code;
    }
}

//=== where the manual contradicts itself ===//

TEST(vlt6000_manual, has_address_and_baud_rate_among_the_serial_parameters_that_only_the_panel_can_set)
{
    VERIFY(find(501)->access == access::panel_only and find(502)->access == access::panel_only);
    VERIFY(find(501)->check_write({22, 0}) == error{errc::read_only, 0});
    VERIFY(find(502)->check_write({5, 0}) == error{errc::read_only, 0});
    VERIFY(find(500)->check_write({1, 0}).ok());
}

TEST(vlt6000_manual, allows_address_0_in_parameter_501_though_no_telegram_can_have_it)
{
    VERIFY(find(501)->check({0, 0}).ok() and find(501)->check({126, 0}).ok() and not find(501)->check({127, 0}).ok());
}

TEST(vlt6000_manual, heads_parameter_532_with_the_display_text_of_a_status_word)
{
    VERIFY(find(532)->display_text == "STATUS WORD" and find(532)->name == "extended_status_word");
    VERIFY(find(527)->display_text == "STATUS WORD HEX" and find(527)->name == "status_word");
}

TEST(vlt6000_manual, says_at_most_20_characters_and_prints_22_of_them)
{
    VERIFY(find(534)->check_text(20).ok() and find(534)->check_text(21) == error{errc::out_of_range, 0});
    VERIFY(not find(534)->check_text(22).ok());
    VERIFY(find(533)->check_text(8).ok() and find(533)->check_text(9) == error{errc::out_of_range, 0});
}

TEST(vlt6000_manual, says_that_texts_can_only_be_read_and_then_writes_two)
{
    for (auto const& row : vlt6000::table) {
        auto const is_written = row.number == 533 or row.number == 534;
        EXPECT_EQ(row.kind == kind::text and row.is_writable(), is_written) << row.number;
        EXPECT_EQ(row.check_text(1).ok(), is_written) << row.number;
        EXPECT_EQ(row.max_text_length > 0, is_written) << row.number;
    }
    VERIFY(find(621)->check_text(1) == error{errc::read_only, 0});
}

TEST(vlt6000_manual, numbers_FLN_2_and_in_the_heading_of_its_addresses_3)
{
    VERIFY(find(500)->check({2, 0}).ok() and find(500)->check({3, 0}) == error{errc::out_of_range, 0});
}

TEST(vlt6000_manual, displays_horsepower_as_HK)
{
    VERIFY(find(516)->display_text == "POWER HK" and find("POWER HP") == nullptr);
    VERIFY(find(516)->unit == unit::horsepower and find("power_in_hp")->number == 516);
}

TEST(vlt6000_manual, updates_the_control_word_every_2_ms_and_its_neighbours_every_20)
{
    VERIFY(find(530)->update_interval == 2);
    VERIFY(find(527)->update_interval == 20 and find(529)->update_interval == 20);
    VERIFY(find(531)->update_interval == 20 and find(532)->update_interval == 20);
}

TEST(vlt6000_manual, calls_the_low_limit_minimum_frequency_and_the_high_limit_max_output_frequency)
{
    VERIFY(find(201)->name == "output_frequency_low_limit" and find("minimum_frequency") == nullptr);
    VERIFY(find(202)->name == "output_frequency_high_limit" and find("max_output_frequency") == nullptr);
}

TEST(vlt6000_manual, has_tenths_of_hertz_but_whole_seconds)
{
    VERIFY(find(206)->value(0x000A) == decimal{10, 0} and find(206)->unit == unit::second);
    VERIFY(find(206)->value(0x000A) != decimal{1, 0});
}

TEST(vlt6000_manual, puts_the_time_out_period_into_556_but_it_is_555)
{
    VERIFY(find(555)->kind == kind::number and find(555)->unit == unit::second and find(555)->check({65534, 0}).ok());
    VERIFY(find(556)->kind == kind::choice and not find(556)->check({65534, 0}).ok());
}

TEST(vlt6000_manual, heads_507_and_508_after_their_description)
{
    VERIFY(find("SELECTING OF SETUP")->number == 507 and find("SELECTING OF SPEED")->number == 508);
    VERIFY(*find(507)->factory_setting == decimal{3, 0} and *find(508)->factory_setting == decimal{3, 0});
}

TEST(vlt6000_manual, calls_415_process_units_and_units_with_closed_loop)
{
    VERIFY(find("process_units")->number == 415 and find("units_with_closed_loop") == nullptr);
}

}  // namespace
