// SPDX-License-Identifier: MIT
#include "support/vlt6000_drive.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

// The simulated VLT 6000, without a line and in a time of its own. Words and rules: VLT 6000 manual.

namespace {

using namespace std::chrono_literals;
using namespace drivecodec::literals;

namespace fc      = drivecodec::fc;
namespace vlt6000 = drivecodec::vlt6000;

using support::vlt6000_drive;
using vlt6000::alarm_word;
using vlt6000::digital_inputs;
using vlt6000::status_word;

constexpr std::uint16_t stop_word  = 0x043C;  // ramp stop, nothing else
constexpr std::uint16_t start_word = 0x047C;  // the same with bit 06

/// A drive at the end of a line that hears a telegram every tenth of a second.
class VltDrive : public testing::Test {
protected:
    VltDrive() { set_ramps(1); }

    void set_ramps(int seconds)
    {
        write(206, seconds);
        write(207, seconds);
    }

    status_word send(unsigned word, std::uint16_t reference = 0)
    {
        auto const given = fc::process_command::read(
            std::array{static_cast<std::uint8_t>(word >> 8), static_cast<std::uint8_t>(word),
                       static_cast<std::uint8_t>(reference >> 8), static_cast<std::uint8_t>(reference)});
        answer_ = drive(given);
        return status_word::from_raw(answer_.status_word());
    }

    /// The same word again and again, as masters do.
    status_word keep_sending(unsigned word, std::uint16_t reference, double seconds)
    {
        auto status = send(word, reference);
        for (auto tenths = std::lround(seconds * 10); tenths > 0; --tenths) {
            drive.go_on(100ms);
            status = send(word, reference);
        }
        return status;
    }
    void run_at_25_hz() { keep_sending(start_word, 0x2000, 2); }

    /// Nobody asks.
    void be_silent(double seconds)
    {
        for (auto hundredths = std::lround(seconds * 100); hundredths > 0; --hundredths) { drive.go_on(10ms); }
    }

    fc::parameter_answer ask(unsigned pke, unsigned ind = 0, std::uint32_t pwe = 0)
    {
        return drive(fc::parameter_request{fc::pke::from_raw(static_cast<std::uint16_t>(pke)),
                                           fc::ind::from_raw(static_cast<std::uint16_t>(ind)), pwe,
                                           fc::data_not_valid});
    }
    std::uint32_t read(unsigned number)
    {
        auto const said = ask(0x1000 | number);
        EXPECT_NE(said.reply(), fc::ak_reply::cannot_be_executed) << number;
        return said.pwe();
    }
    /// To RAM, as wide as the drive has it.
    void write(unsigned number, int value)
    {
        auto const is_word = ask(0x1000 | number).reply() == fc::ak_reply::word;
        auto const bits    = static_cast<std::uint32_t>(value);
        auto const said    = ask((is_word ? 0x2000U : 0x3000U) | number, 0, is_word ? bits & 0xFFFFU : bits);
        EXPECT_NE(said.reply(), fc::ak_reply::cannot_be_executed) << number << ": error " << said.pwe();
    }
    static void expect_error(unsigned number, fc::parameter_answer said)
    {
        EXPECT_EQ(said.reply(), fc::ak_reply::cannot_be_executed);
        EXPECT_EQ(said.pwe(), number);
    }
    [[nodiscard]] bool is_running() const { return drive.status().test(status_word::running); }

    vlt6000_drive::settings settings{};
    vlt6000_drive           drive{settings};
    fc::process_status      answer_;
};

//=== control word ===//

TEST_F(VltDrive, word_without_data_valid_is_ignored)
{
    send(start_word & ~0x0400U, 0x2000);
    drive.go_on(1s);
    EXPECT_EQ(drive.frequency(), 0);
    EXPECT_EQ(read(530), 0x003CU);

    run_at_25_hz();
    send(0x0000, 0);
    drive.go_on(900ms);
    EXPECT_EQ(drive.frequency(), 25);
    EXPECT_EQ(read(530), start_word);
}

TEST_F(VltDrive, start_command_of_the_manual_leads_to_its_example_of_a_status_word)
{
    auto const status = keep_sending(0x047F, 0x2000, 2);
    EXPECT_EQ(status.raw, 0x0F03);
    EXPECT_EQ(drive.frequency(), 25);
    EXPECT_EQ(answer_.output_frequency().raw(), 0x2000);
}

TEST_F(VltDrive, ramps_take_their_time_to_the_nominal_frequency)
{
    set_ramps(10);
    keep_sending(start_word, 0x4000, 5);
    EXPECT_NEAR(drive.frequency(), 25, 1e-9);
    EXPECT_FALSE(drive.status().test(status_word::speed_equals_reference));
    write(207, 5);
    keep_sending(stop_word, 0, 1);
    EXPECT_NEAR(drive.frequency(), 15, 1e-9);
    EXPECT_TRUE(is_running());
    keep_sending(stop_word, 0, 2);
    EXPECT_EQ(drive.frequency(), 0);
    EXPECT_FALSE(is_running());
}

TEST_F(VltDrive, negative_reference_turns_the_other_way)
{
    keep_sending(start_word, 0xE000, 2);
    EXPECT_EQ(drive.frequency(), -25);
    EXPECT_EQ(answer_.output_frequency().raw(), 0xE000);
}

TEST_F(VltDrive, reference_is_between_204_and_205_and_output_between_201_and_202)
{
    write(202, 1000);
    write(204, 10'000);
    write(205, 60'000);
    keep_sending(start_word, 0x2000, 2);
    EXPECT_EQ(drive.frequency(), 35);
    EXPECT_EQ(answer_.output_frequency().raw(), 0x4000 * 35 / 100);
    write(202, 300);
    keep_sending(start_word, 0x2000, 1);
    EXPECT_EQ(drive.frequency(), 30);
    EXPECT_FALSE(drive.status().test(status_word::within_frequency_range));
    EXPECT_EQ(answer_.output_frequency().raw(), 0x4000);
}

TEST_F(VltDrive, coasting_lets_go_at_once)
{
    run_at_25_hz();
    send(start_word & ~0x0008U, 0x2000);
    EXPECT_EQ(drive.frequency(), 0);
    EXPECT_FALSE(is_running());
    keep_sending(start_word, 0x2000, 1);
    EXPECT_EQ(drive.frequency(), 25);
}

TEST_F(VltDrive, dc_brake_and_quick_stop_win_over_start)
{
    run_at_25_hz();
    send(start_word & ~0x0004U, 0x2000);
    EXPECT_EQ(drive.frequency(), 0);
    EXPECT_NE(read(532) & 0x00400000U, 0U);
    run_at_25_hz();
    keep_sending(start_word & ~0x0010U, 0x2000, 0.2);
    EXPECT_NEAR(drive.frequency(), 15, 1e-9);
    keep_sending(start_word & ~0x0010U, 0x2000, 1);
    EXPECT_EQ(drive.frequency(), 0);
}

TEST_F(VltDrive, frozen_output_is_left_by_coasting_and_dc_brake_only)
{
    for (unsigned const leaving : {0x0008U, 0x0004U}) {
        keep_sending(start_word, 0x2000, 0.2);
        auto const frozen = drive.frequency();
        EXPECT_EQ(frozen, 10);
        keep_sending(start_word & ~0x0020U, 0x4000, 1);
        EXPECT_EQ(drive.frequency(), frozen);
        keep_sending(stop_word & ~0x0020U, 0, 1);
        EXPECT_EQ(drive.frequency(), frozen);
        EXPECT_TRUE(is_running());
        send(stop_word & ~0x0020U & ~leaving, 0);
        EXPECT_EQ(drive.frequency(), 0);
        keep_sending(stop_word, 0, 0.1);
    }
}

TEST_F(VltDrive, terminal_27_leaves_a_frozen_output)
{
    run_at_25_hz();
    send(start_word & ~0x0020U, 0x2000);
    drive.toggle(digital_inputs::terminal_27);
    EXPECT_EQ(drive.frequency(), 0);
}

TEST_F(VltDrive, jog_is_the_frequency_of_209)
{
    write(209, 75);
    keep_sending(stop_word | 0x0100U, 0x4000, 1);
    EXPECT_EQ(drive.frequency(), 7.5);
    keep_sending(stop_word, 0x4000, 1);
    EXPECT_EQ(drive.frequency(), 0);
}

TEST_F(VltDrive, preset_references_are_added)
{
    write(211, 1'000);
    write(212, 2'000);
    write(213, -3'000);
    write(214, 10'000);
    for (auto const& [bits, hz] : {std::pair{0U, 10.0}, {1U, 15.0}, {2U, -10.0}, {3U, 50.0}}) {
        keep_sending(start_word | bits, 0x0666, 3);  // 1638 of 16384 are 9.997 %
        EXPECT_NEAR(drive.frequency(), hz, 0.01) << bits;
    }
}

TEST_F(VltDrive, setups_have_parameters_of_their_own)
{
    keep_sending(start_word | 0x2000, 0x2000, 2);  // without multi-setup, the bits choose nothing
    EXPECT_EQ(drive.frequency(), 25);
    write(4, 1);
    send(0x2400 | start_word, 0x2000);
    EXPECT_EQ(read(206), 10U);  // setup 2 has the factory setting
    write(206, 3);
    send(start_word, 0x2000);
    EXPECT_EQ(read(206), 1U);
    send(0x2000 | start_word, 0x2000);
    EXPECT_EQ(read(206), 3U);
    send(0x6000 | start_word, 0x2000);
    EXPECT_EQ(read(206), 10U);
}

TEST_F(VltDrive, relays_follow_bits_11_and_12_if_323_and_326_say_so)
{
    send(stop_word | 0x1800U);
    EXPECT_FALSE(drive.relay_1() or drive.relay_2());
    write(323, 26);
    EXPECT_TRUE(drive.relay_1() and not drive.relay_2());
    write(326, 26);
    send(stop_word | 0x1000U);
    EXPECT_TRUE(not drive.relay_1() and drive.relay_2());
    be_silent(1.1);  // also while 556 is off
    EXPECT_FALSE(drive.relay_1() or drive.relay_2());
}

//=== trips ===//

TEST_F(VltDrive, trip_is_reset_by_an_edge)
{
    run_at_25_hz();
    send(start_word | 0x0080U, 0x2000);
    drive.trip(alarm_word::of(alarm_word::earth_fault));
    EXPECT_EQ(drive.frequency(), 0);
    auto const tripped = send(start_word | 0x0080U, 0x2000);  // was 1 already
    EXPECT_TRUE(tripped.test(status_word::tripped));
    EXPECT_FALSE(tripped.test(status_word::control_ready));
    EXPECT_EQ(read(529), 0x400U);
    EXPECT_EQ(ask(0x1267, 1).pwe(), 11U);

    send(stop_word);
    EXPECT_TRUE(drive.status().test(status_word::tripped));
    send(stop_word | 0x0080U);
    EXPECT_FALSE(drive.status().test(status_word::tripped));
    EXPECT_EQ(read(529), 0U);
    EXPECT_EQ(ask(0x1267, 1).pwe(), 11U);
}

TEST_F(VltDrive, locked_trip_is_reset_by_mains_only)
{
    drive.trip(alarm_word::of(alarm_word::trip_locked, alarm_word::short_circuiting));
    send(stop_word);
    send(stop_word | 0x0080U);
    EXPECT_TRUE(drive.status().test(status_word::tripped));
    drive.power_cycle();
    EXPECT_FALSE(drive.status().test(status_word::tripped));
}

TEST_F(VltDrive, warnings_are_in_the_status_word)
{
    using vlt6000::warning_word;
    drive.warn(warning_word::of(warning_word::voltage_warning_low));
    EXPECT_EQ(drive.status().raw, 0x2687);
    EXPECT_EQ(read(531), 0x1000U);
    drive.warn(warning_word::of(warning_word::current_limit, warning_word::motor_thermistor));
    EXPECT_EQ(drive.status().raw, 0xC687);
    drive.warn({});
    EXPECT_EQ(drive.status().raw, 0x0607);
}

TEST_F(VltDrive, local_operation_obeys_no_word)
{
    drive.toggle_local();
    auto const status = keep_sending(start_word, 0x2000, 1);
    EXPECT_TRUE(status.is_local());
    EXPECT_EQ(drive.frequency(), 0);
    drive.toggle_local();
    keep_sending(start_word, 0x2000, 1);
    EXPECT_EQ(drive.frequency(), 25);
}

//=== gating: 503 to 508 with terminals ===//

/// Does the drive run, with this gating, these terminals and this word?
bool runs(unsigned parameter, int gating, digital_inputs closed, std::uint16_t word, bool terminal_19_brakes = false)
{
    vlt6000_drive::settings settings;
    settings.closed             = closed;
    settings.terminal_19_brakes = terminal_19_brakes;
    vlt6000_drive drive{settings};
    static_cast<void>(drive(fc::parameter_request{fc::pke::from_raw(static_cast<std::uint16_t>(0x2000 | parameter)),
                                                  {},
                                                  static_cast<std::uint32_t>(gating),
                                                  fc::data_not_valid}));
    static_cast<void>(drive(fc::data_valid(word, 50_percent)));
    drive.go_on(100ms);
    return drive.frequency() != 0;
}

TEST(VltDriveGating, coasting)
{
    // Digital, serial, and, or: of a command that is active at 0, "and" coasts only where both ask.
    struct row {
        bool                terminal;
        bool                bit;
        std::array<bool, 4> runs;
    };
    for (auto const& [terminal, bit, wanted] :
         {row{false, false, {false, false, false, false}}, row{false, true, {false, true, true, false}},
          row{true, false, {true, false, true, false}}, row{true, true, {true, true, true, true}}}) {
        auto const closed = terminal ? digital_inputs::of(digital_inputs::terminal_27) : digital_inputs{};
        for (int gating = 0; gating < 4; ++gating) {
            auto const word = static_cast<std::uint16_t>(bit ? start_word : start_word & ~0x0008U);
            EXPECT_EQ(runs(503, gating, closed, word), wanted.at(static_cast<unsigned>(gating)))
                << gating << terminal << bit;

            using t            = digital_inputs;
            auto const braking = terminal ? t::of(t::terminal_27, t::terminal_19) : t::of(t::terminal_27);
            auto const brake   = static_cast<std::uint16_t>(bit ? start_word : start_word & ~0x0004U);
            EXPECT_EQ(runs(504, gating, braking, brake, true), wanted.at(static_cast<unsigned>(gating)));
        }
    }
}

TEST(VltDriveGating, start)
{
    using t = digital_inputs;
    for (int gating = 0; gating < 4; ++gating) {
        for (bool const terminal : {false, true}) {
            for (bool const bit : {false, true}) {
                auto const       closed = terminal ? t::of(t::terminal_27, t::terminal_18) : t::of(t::terminal_27);
                std::array const wanted{terminal, bit, terminal and bit, terminal or bit};
                EXPECT_EQ(runs(505, gating, closed, bit ? start_word : stop_word),
                          wanted.at(static_cast<unsigned>(gating)));
            }
        }
    }
}

TEST_F(VltDrive, reversing_bit_needs_506)
{
    keep_sending(start_word | 0x8000U, 0x2000, 1);
    EXPECT_EQ(drive.frequency(), 25);
    write(506, 1);
    keep_sending(start_word | 0x8000U, 0x2000, 2);
    EXPECT_EQ(drive.frequency(), -25);
    write(506, 0);
    drive.toggle(digital_inputs::terminal_19);
    keep_sending(start_word, 0x2000, 2);
    EXPECT_EQ(drive.frequency(), -25);
}

TEST_F(VltDrive, terminals_choose_presets_and_setups_too)
{
    write(213, 1'000);
    write(214, 2'000);
    drive.toggle(digital_inputs::terminal_17);  // the msb
    keep_sending(start_word, 0, 1);
    EXPECT_EQ(drive.frequency(), 5);
    keep_sending(start_word | 1U, 0, 1);  // bit by bit: 2 or 1 is 3
    EXPECT_EQ(drive.frequency(), 10);
    write(508, 1);
    keep_sending(start_word, 0, 1);
    EXPECT_EQ(drive.frequency(), 0);

    write(4, 1);
    drive.toggle(digital_inputs::terminal_32);
    send(start_word);
    EXPECT_EQ(read(214), 0U);  // of setup 2
}

//=== bus time-out ===//

class VltDriveTimeOut : public VltDrive {
protected:
    /// Runs, and is then asked nothing until the reaction is over.
    void time_out(int reaction)
    {
        write(209, 50);
        write(556, reaction);
        keep_sending(start_word, 0x2000, 1);
        auto const before = drive.frequency();
        be_silent(0.99);
        EXPECT_EQ(drive.frequency(), before);
        be_silent(2);
    }
};

TEST_F(VltDriveTimeOut, off_goes_on)
{
    time_out(0);
    EXPECT_EQ(drive.frequency(), 25);
    EXPECT_FALSE(drive.status().test(status_word::warning));
}
TEST_F(VltDriveTimeOut, freezes_on_its_ramp)
{
    set_ramps(5);
    write(556, 1);
    send(start_word, 0x4000);
    be_silent(3);
    EXPECT_NEAR(drive.frequency(), 10, 0.2);
    EXPECT_TRUE(drive.status().test(status_word::warning));
    keep_sending(start_word, 0x4000, 5);
    EXPECT_EQ(drive.frequency(), 50);
    EXPECT_FALSE(drive.status().test(status_word::warning));
}
TEST_F(VltDriveTimeOut, stops)
{
    time_out(2);
    EXPECT_EQ(drive.frequency(), 0);
    EXPECT_FALSE(drive.status().test(status_word::tripped));
    keep_sending(start_word, 0x2000, 1);
    EXPECT_EQ(drive.frequency(), 25);
}
TEST_F(VltDriveTimeOut, reaction_3_is_jog_and_not_preset_reference_1)
{
    write(211, 2'000);
    time_out(3);
    EXPECT_EQ(drive.frequency(), 5);
}
TEST_F(VltDriveTimeOut, goes_to_the_high_limit)
{
    time_out(4);
    EXPECT_EQ(drive.frequency(), 50);
}
TEST_F(VltDriveTimeOut, stops_and_trips)
{
    time_out(5);
    EXPECT_EQ(drive.frequency(), 0);
    EXPECT_EQ(read(529), 0x10U);
    send(stop_word);
    EXPECT_TRUE(drive.status().test(status_word::tripped));
    send(stop_word | 0x0080U);
    EXPECT_FALSE(drive.status().test(status_word::tripped));
}
TEST_F(VltDriveTimeOut, a_stop_and_trip_that_began_is_not_called_off_by_a_telegram)
{
    set_ramps(10);
    write(556, 5);
    keep_sending(start_word, 0x2000, 12);
    be_silent(1.5);
    EXPECT_GT(drive.frequency(), 20);
    keep_sending(start_word, 0x2000, 8);
    EXPECT_EQ(drive.frequency(), 0);
    EXPECT_TRUE(drive.status().test(status_word::tripped));
    EXPECT_EQ(read(529), 0x10U);
}
TEST_F(VltDriveTimeOut, period_is_555_and_not_556)
{
    write(555, 3);
    write(556, 2);
    run_at_25_hz();
    be_silent(2.9);
    EXPECT_EQ(drive.frequency(), 25);
    be_silent(1);
    EXPECT_EQ(drive.frequency(), 0);
}
TEST_F(VltDriveTimeOut, telegram_without_data_valid_is_one)
{
    write(556, 2);
    run_at_25_hz();
    for (int i = 0; i < 5; ++i) {
        be_silent(0.9);
        send(0);
    }
    EXPECT_EQ(drive.frequency(), 25);
}
TEST_F(VltDriveTimeOut, nothing_starts_by_itself)
{
    for (int const reaction : {1, 2, 3, 4}) {
        write(556, reaction);
        send(stop_word);
        be_silent(3);
        EXPECT_EQ(drive.frequency(), 0) << reaction;
    }
}
TEST_F(VltDriveTimeOut, begins_with_the_first_telegram)
{
    write(556, 5);
    be_silent(100);
    EXPECT_FALSE(drive.status().test(status_word::tripped));
}

//=== parameters ===//

TEST_F(VltDrive, every_parameter_of_the_table_answers)
{
    for (auto const& row : vlt6000::table) {
        if (row.kind == vlt6000::kind::text) {
            auto const text = drive(fc::text_request{fc::pke::from_raw(static_cast<std::uint16_t>(0xF000 | row.number)),
                                                     fc::ind::from_raw(0x0400),
                                                     {},
                                                     fc::data_not_valid});
            ASSERT_TRUE(text) << row.number;
            EXPECT_EQ(text->empty(), row.access == vlt6000::access::write_only) << row.number;
            continue;
        }
        auto const said = ask(0x1000U | row.number, row.is_array ? 1 : 0);
        EXPECT_TRUE(said.reply() == fc::ak_reply::word or said.reply() == fc::ak_reply::double_word) << row.number;
        if (row.width) { EXPECT_EQ(fc::width_of(said.reply()), *row.width) << row.number; }
        if (row.factory_setting and row.conversion_index) {
            EXPECT_EQ(row.value(static_cast<std::int32_t>(said.pwe())), *row.factory_setting) << row.number;
        }
        if (row.factory_setting and not row.conversion_index) {
            EXPECT_EQ((drivecodec::decimal{static_cast<std::int32_t>(said.pwe()), 0}), *row.factory_setting)
                << row.number;
        }
    }
}

TEST_F(VltDrive, every_setting_has_its_limits)
{
    for (auto const& row : support::vlt6000_settings::table) {
        ASSERT_NE(vlt6000::find(row.number), nullptr) << row.number;
        EXPECT_LE(row.min, row.factory) << row.number;
        EXPECT_LE(row.factory, row.max) << row.number;
        if (row.number == 501 or row.number == 502 or row.max == support::detail::any_double_word) { continue; }
        auto const is_word = fc::width_of(row.type) == fc::width::word;
        auto const beyond  = static_cast<std::uint32_t>(row.max + 1);
        expect_error(2, ask((is_word ? 0x2000U : 0x3000U) | row.number, 0, is_word ? beyond & 0xFFFFU : beyond));
    }
}

TEST_F(VltDrive, error_replies)
{
    expect_error(0, ask(0x1000 | 300));
    expect_error(0, ask(0x2000 | 300, 0, 1));
    expect_error(1, ask(0x2000 | 512, 0, 1));
    expect_error(1, ask(0x2000 | 615, 1, 1));
    expect_error(2, ask(0xE000 | 202, 0, 1201));
    expect_error(2, ask(0xE000 | 202, 0, 0));  // not above 201
    expect_error(3, ask(0x1000 | 615, 0));
    expect_error(3, ask(0x1000 | 615, 11));
    expect_error(4, ask(0x1000 | 202, 1));
    expect_error(4, ask(0xE000 | 202, 1, 1000));
    expect_error(5, ask(0xD000 | 202, 0, 1000));
    expect_error(5, ask(0x3000 | 202, 0, 1000));
    expect_error(5, ask(0x2000 | 204, 0, 1000));
    expect_error(5, ask(0x2000 | 202, 0, 0x00010000));
    expect_error(5, ask(0x1000 | 621));
    expect_error(130, ask(0x2000 | 501, 0, 5));
    expect_error(130, ask(0x2000 | 502, 0, 5));
    run_at_25_hz();
    expect_error(17, ask(0x2000 | 104, 0, 60));
    expect_error(17, ask(0x2000 | 500, 0, 1));
    for (unsigned const ak : {4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U}) { expect_error(5, ask(ak << 12 | 202U)); }
}

TEST_F(VltDrive, factory_setup_cannot_be_changed)
{
    write(2, 0);
    EXPECT_EQ(read(206), 10U);
    expect_error(131, ask(0x2000 | 206, 0, 5));
    write(2, 1);
    EXPECT_EQ(read(206), 1U);
    write(206, 5);
}

TEST_F(VltDrive, ram_forgets_and_eeprom_remembers)
{
    write(202, 600);
    EXPECT_EQ(ask(0xE000 | 209, 0, 123).pwe(), 123U);
    run_at_25_hz();
    drive.power_cycle();
    EXPECT_EQ(read(202), 500U);
    EXPECT_EQ(read(209), 123U);
    EXPECT_EQ(drive.frequency(), 0);
    EXPECT_EQ(read(530), 0x003CU);
}

TEST_F(VltDrive, eeprom_may_be_a_file)
{
    auto const path = testing::TempDir() + "vlt6000_eeprom";
    static_cast<void>(std::remove(path.c_str()));
    settings.eeprom = path;
    {
        vlt6000_drive first{settings};
        static_cast<void>(first(fc::write_word(202, 1000, fc::storage::ram_and_eeprom, fc::data_not_valid)));
        static_cast<void>(first(fc::write_word(206, 77, fc::storage::ram, fc::data_not_valid)));
    }
    {
        vlt6000_drive second{settings};
        EXPECT_EQ(second(fc::read_value(202, fc::data_not_valid)), fc::parameter_answer::value(std::uint16_t{1000}));
        EXPECT_EQ(second(fc::read_value(206, fc::data_not_valid)), fc::parameter_answer::value(std::uint16_t{10}));
    }
    std::ofstream{path} << "no EEPROM\n";
    EXPECT_THROW(vlt6000_drive{settings}, std::system_error);
    static_cast<void>(std::remove(path.c_str()));
}

TEST_F(VltDrive, read_outs_follow_the_motor)
{
    write(535, 0x2000);
    run_at_25_hz();
    EXPECT_EQ(read(509), 500U);
    EXPECT_EQ(read(510), 25'000U);
    EXPECT_EQ(read(511), 50'000U);
    EXPECT_EQ(read(512), 250U);
    EXPECT_EQ(read(513), 5'000U);
    EXPECT_EQ(read(517), 200U);
    EXPECT_EQ(read(521), 0x08U);
    EXPECT_EQ(read(527), 0x0F03U);
    EXPECT_EQ(read(530), start_word);
    EXPECT_EQ(read(532), 0x06800E00U);  // speed = reference, running, remote, twice drive ready, control ready
}

//=== texts ===//

TEST_F(VltDrive, texts)
{
    auto const ask_text = [&](unsigned number, unsigned ind, std::string const& text = {}) {
        std::vector<std::uint8_t> const characters{text.begin(), text.end()};
        auto const                      said =
            drive(fc::text_request{fc::pke::from_raw(static_cast<std::uint16_t>(0xF000 | number)),
                                   fc::ind::from_raw(static_cast<std::uint16_t>(ind)), characters, fc::data_not_valid});
        return said ? std::string{said->begin(), said->end()}
                    : "error " + std::to_string(static_cast<unsigned>(said.error()));
    };
    EXPECT_EQ(ask_text(621, 0x0400), "VLT 6006 HVAC");
    EXPECT_EQ(ask_text(533, 0x0500, "EIGHT888"), "EIGHT888");
    EXPECT_EQ(ask_text(533, 0x0400), "EIGHT888");
    EXPECT_EQ(ask_text(534, 0x0500, "twenty characters 20"), "twenty characters 20");
    EXPECT_EQ(drive.line(0), "EIGHT888");
    EXPECT_EQ(drive.line(1), "twenty characters 20");
    EXPECT_EQ(ask_text(533, 0x0500, "NINECHARS"), "error 2");
    EXPECT_EQ(ask_text(534, 0x0500, "twenty-one characters"), "error 2");
    EXPECT_EQ(ask_text(621, 0x0500, "NO"), "error 1");
    EXPECT_EQ(ask_text(620, 0x0400), "error 0");
    EXPECT_EQ(ask_text(202, 0x0400), "error 5");
    EXPECT_EQ(ask_text(621, 0x0000), "error 3");
    EXPECT_EQ(ask_text(533, 0x0400), "EIGHT888");
}

}  // namespace
