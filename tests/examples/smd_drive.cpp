// SPDX-License-Identifier: MIT
#include "support/smd_drive.hpp"

#include <gtest/gtest.h>

#include <drivecodec/drives/smd/controller.hpp>
#include <drivecodec/modbus/rtu/client.hpp>

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

// The simulated smd, without a line and in a time of its own. Registers and rules: smd manual.

namespace {

using namespace std::chrono_literals;

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;
namespace smd    = drivecodec::smd;

using support::smd_drive;
using enum smd::operational_status;

constexpr int answered  = 0;  // else the number of the exception
constexpr int no_answer = -1;

/// A drive at the end of a line, with address 5.
class SmdDrive : public testing::TestWithParam<smd::version> {
protected:
    [[nodiscard]] static smd_drive::settings usual()
    {
        smd_drive::settings chosen;
        chosen.link.address = 5;
        return chosen;
    }

    /// The PDU of the reply; none if there is no reply.
    std::vector<std::uint8_t> send(std::vector<std::uint8_t> const& pdu, std::uint8_t address = 5)
    {
        std::vector<std::uint8_t> frame{address};
        frame.insert(frame.end(), pdu.begin(), pdu.end());
        frame.resize(frame.size() + 2);
        rtu::write_crc(frame);
        std::array<std::uint8_t, rtu::max_adu_size> room{};
        auto const                                  reply =
            drive.answer_frame({.raw = frame, .direction = modbus::direction::request, .aligned = true}, room);
        if (reply.empty()) { return {}; }
        EXPECT_EQ(reply.front(), address);
        EXPECT_TRUE(rtu::has_valid_crc(reply));
        return {reply.begin() + 1, reply.end() - 2};
    }

    static std::uint8_t high(int number) { return static_cast<std::uint8_t>(number >> 8); }
    static std::uint8_t low(int number) { return static_cast<std::uint8_t>(number); }

    static int outcome(std::vector<std::uint8_t> const& reply)
    {
        if (reply.empty()) { return no_answer; }
        return (reply[0] & 0x80) != 0 ? reply.at(1) : answered;
    }

    int write(int address, int value)
    {
        std::vector<std::uint8_t> const request{6, high(address), low(address), high(value), low(value)};
        auto const                      reply = send(request);
        if (outcome(reply) == answered) { EXPECT_EQ(reply, request); }
        return outcome(reply);
    }
    int write_by_16(int address, int value, int count = 1)
    {
        std::vector<std::uint8_t> request{16, high(address), low(address), 0, low(count), low(2 * count)};
        for (int i = 0; i < count; ++i) { request.insert(request.end(), {high(value), low(value)}); }
        return outcome(send(request));
    }
    std::vector<std::uint8_t> ask(int address, int count, int function = 3)
    {
        return send({low(function), high(address), low(address), high(count), low(count)});
    }
    int read(int address)
    {
        auto const reply = ask(address, 1);
        EXPECT_EQ(outcome(reply), answered) << address;
        return outcome(reply) == answered ? reply.at(2) << 8 | reply.at(3) : -1;
    }

    void pass(double seconds)
    {
        for (auto left = std::lround(seconds * 1000); left > 0; left -= 5) { drive.go_on(5ms); }
    }
    [[nodiscard]] smd::operational_status status() const { return drive.status().operational_status; }

    /// Registers of PV507.
    void run_at(int tenths_of_hertz)
    {
        ASSERT_EQ(write(48, 0), answered);
        ASSERT_EQ(write(61, 10), answered);
        ASSERT_EQ(write(62, 10), answered);
        ASSERT_EQ(write(1, 0x0100), answered);
        ASSERT_EQ(write(40, tenths_of_hertz), answered);
        ASSERT_EQ(write(1, 0x0008), answered);
        pass(2);
        ASSERT_EQ(status(), run);
    }

    smd_drive drive{usual()};
};

//=== locks ===//

TEST_F(SmdDrive, every_write_to_a_locked_drive_is_exception_1)
{
    for (int address = 0; address < 300; ++address) {
        if (address == 48 or address == 49) { continue; }
        EXPECT_EQ(write(address, 2), 1) << address;
        EXPECT_EQ(write_by_16(address, 2), 1) << address;
    }
    EXPECT_EQ(write(48, 7), 1);
    EXPECT_EQ(write(49, 7), 1);
    EXPECT_EQ(write(48, 1000), 3);
    EXPECT_EQ(read(61), 50);
    EXPECT_EQ(drive.lock_state(), smd::lock_state::locked);
}

TEST_F(SmdDrive, zero_unlocks_everything_while_the_password_is_0)
{
    EXPECT_EQ(write(48, 0), answered);
    EXPECT_EQ(write(1, 0x0004), answered);
    EXPECT_EQ(write(61, 100), answered);
    EXPECT_EQ(write(1, 0x0002), answered);
    EXPECT_EQ(write(61, 100), 1);
}

TEST_F(SmdDrive, with_a_password_zero_unlocks_control_only)
{
    auto chosen     = usual();
    chosen.password = 123;
    drive           = smd_drive{chosen};
    EXPECT_EQ(write(49, 0), 1);
    EXPECT_EQ(write(48, 0), answered);
    EXPECT_EQ(write(1, 0x0004), answered);
    EXPECT_EQ(write(40, 100), answered);
    EXPECT_EQ(write(61, 100), 1);
    EXPECT_EQ(write(49, 123), answered);
    EXPECT_EQ(write(61, 100), answered);
}

TEST_F(SmdDrive, parameters_alone_leave_register_1_locked)
{
    EXPECT_EQ(write(49, 0), answered);
    EXPECT_EQ(write(61, 100), answered);
    EXPECT_EQ(write(40, 100), answered);
    EXPECT_EQ(write(1, 0x0008), 1);
    EXPECT_EQ(write(1, 0x0002), answered);
    EXPECT_EQ(write(61, 100), 1);
}

TEST_F(SmdDrive, c01_8_and_9_are_only_for_watching_and_below_there_is_no_modbus)
{
    for (std::uint16_t mode = 0; mode < 12; ++mode) {
        auto chosen         = usual();
        chosen.control_mode = smd::control_mode{mode};
        drive               = smd_drive{chosen};
        EXPECT_EQ(outcome(ask(24, 6)), mode >= 8 ? answered : no_answer) << mode;
        EXPECT_EQ(write(48, 0), mode >= 10 ? answered : mode >= 8 ? 1 : no_answer) << mode;
    }
}

TEST_F(SmdDrive, another_control_source_ends_control_and_stops_the_motor)
{
    run_at(100);
    EXPECT_EQ(write(51, 10), answered);
    EXPECT_EQ(status(), run);
    EXPECT_EQ(write(51, 9), answered);
    EXPECT_EQ(status(), off);
    EXPECT_EQ(write(1, 0x0008), 1);
    EXPECT_EQ(drive.lock_state(), smd::lock_state::locked);
}

/// Against the sentences of sections 4.5 and 4.6, one after the other.
TEST_F(SmdDrive, random_writes_pass_as_the_manual_says)
{
    auto chosen     = usual();
    chosen.password = 5;
    drive           = smd_drive{chosen};
    std::mt19937 random{1};
    auto         has_control    = false;
    auto         has_parameters = false;
    for (int i = 0; i < 20'000; ++i) {
        switch (random() % 8) {
        case 0:
            EXPECT_EQ(write(48, 0), answered);
            has_control = true;
            break;
        case 1:
            EXPECT_EQ(write(48, 5), answered);
            has_control = has_parameters = true;
            break;
        case 2:
            EXPECT_EQ(write(49, 5), answered);
            has_parameters = true;
            break;
        case 3: EXPECT_EQ(write(48 + static_cast<int>(random() % 2), 6), 1); break;
        case 4: EXPECT_EQ(write(1, 0x0004), has_control ? answered : 1); break;
        case 5: EXPECT_EQ(write(40, 100), has_control or has_parameters ? answered : 1); break;
        case 6: EXPECT_EQ(write(61, 100), has_parameters ? answered : 1); break;
        default:
            if (random() % 4 != 0) { break; }
            EXPECT_EQ(write(1, 0x0002), has_control or has_parameters ? answered : 1);
            has_control = has_parameters = false;
        }
        EXPECT_EQ(outcome(ask(24, 6)), answered);
    }
}

//=== register 1 ===//

TEST_F(SmdDrive, several_bits_are_exception_4_and_with_stop_only_stop)
{
    for (int word = 0; word < 0x10000; ++word) {
        if (word == 0x0002) { continue; }  // the lock
        drive = smd_drive{usual()};
        write(48, 0);
        write(1, 0x0008);
        auto const is_single  = (word & (word - 1)) == 0;
        auto const is_command = (word & ~0x03CF) == 0 and word != 0;
        auto const has_stop   = (word & 0x0004) != 0;
        auto const wanted     = has_stop ? answered : not is_single ? 4 : is_command ? answered : 3;
        ASSERT_EQ(write(1, word), wanted) << word;
        ASSERT_EQ(status(), has_stop ? off : run_at_0_hz) << word;
        ASSERT_EQ(drive.status().commanded_direction,
                  word == 0x0040 ? smd::direction::reverse : smd::direction::forward);
        ASSERT_EQ(drive.status().speed_reference,
                  word == 0x0100 ? smd::speed_reference::serial : smd::speed_reference::local);
        ASSERT_EQ(drive.lock_state(), smd::lock_state::both);
    }
}

TEST_F(SmdDrive, example_of_the_manual_runs_at_41_2_hertz)
{
    EXPECT_EQ(write_by_16(48, 0), answered);
    EXPECT_EQ(write(1, 0x0100), answered);
    EXPECT_EQ(write(40, 412), answered);
    EXPECT_EQ(write(1, 0x0008), answered);
    EXPECT_EQ(status(), accel);
    pass(5);
    EXPECT_EQ(read(26) & 0xFF, 6);
    auto const block = ask(24, 6);
    ASSERT_EQ(block.size(), 14U);
    EXPECT_EQ((std::vector<std::uint8_t>{block.begin(), block.begin() + 6}),
              (std::vector<std::uint8_t>{3, 12, 0x01, 0x9C, 0x01, 0x9C}));
    EXPECT_EQ((std::vector<std::uint8_t>{block.begin() + 8, block.end()}),
              (std::vector<std::uint8_t>{0, 11, 6, 0, 0, 0}));
}

TEST_F(SmdDrive, direction_turns_through_standstill)
{
    run_at(500);
    write(1, 0x0040);
    EXPECT_EQ(status(), decel);
    pass(0.5);
    EXPECT_NEAR(drive.speed(), 25, 0.5);
    EXPECT_EQ(drive.status().actual_direction, smd::direction::forward);
    pass(1);
    EXPECT_EQ(status(), accel);
    EXPECT_EQ(drive.status().actual_direction, smd::direction::reverse);
    pass(1);
    EXPECT_EQ(status(), run);
    EXPECT_EQ(drive.speed(), 50);
}

//=== reading ===//

TEST_F(SmdDrive, reads_are_of_one_register_but_for_two)
{
    for (int address = 0; address < 300; ++address) {
        for (auto const count : {0, 2, 3, 4, 5, 6, 7, 125}) {
            auto const is_possible = (address == 24 and count == 6) or (address == 95 and count == 4);
            EXPECT_EQ(outcome(ask(address, count)), is_possible ? answered : 3) << address << ' ' << count;
            EXPECT_EQ(outcome(ask(address, count, 4)), is_possible ? answered : 3) << address << ' ' << count;
        }
    }
    EXPECT_EQ(outcome(ask(0, 1)), 2);
    EXPECT_EQ(outcome(ask(56, 1)), 2);
    for (auto const write_only : {1, 48, 49}) { EXPECT_EQ(outcome(ask(write_only, 1)), 2); }
}

TEST_P(SmdDrive, every_parameter_has_its_factory_setting_and_takes_its_limits)
{
    auto chosen    = usual();
    chosen.version = GetParam();
    drive          = smd_drive{chosen};
    write(48, 0);
    smd::map const map{GetParam()};
    EXPECT_EQ(read(50), static_cast<int>(GetParam()));
    for (std::uint16_t address = 51; address < 256; ++address) {
        auto const* const row = map.find(address);
        if (row == nullptr) {
            EXPECT_EQ(outcome(ask(address, 1)), 2) << address;
            EXPECT_EQ(write(address, 0), 2) << address;
            continue;
        }
        SCOPED_TRACE(row->code);
        auto const before = read(address);
        EXPECT_EQ(outcome(ask(address, 1, 4)), answered);
        if (not row->is_writable()) {
            EXPECT_EQ(write(address, 0), 2);
            continue;
        }
        if (row->code != "C01") { EXPECT_EQ(before, row->code == "C09" ? 5 : row->factory_setting.number); }
        if (row->limits.max < 0xFFFF) { EXPECT_EQ(write(address, row->limits.max + 1), 3); }
        if (row->limits.min > 0) { EXPECT_EQ(write(address, row->limits.min - 1), 3); }
        if (row->code == "C02" or row->code == "c81") { continue; }
        EXPECT_EQ(write(address, row->limits.max), answered);
        EXPECT_EQ(read(address), row->limits.max);
        EXPECT_EQ(write(address, before), answered);
    }
}
INSTANTIATE_TEST_SUITE_P(Versions, SmdDrive, testing::Values(smd::pv400, smd::pv507),
                         [](auto const& given) { return given.param == smd::pv400 ? "pv400" : "pv507"; });

TEST_F(SmdDrive, software_version_is_a_text_of_four_words_that_are_no_other_registers)
{
    auto const text = ask(95, 4);
    EXPECT_EQ((std::string{text.begin() + 2, text.end()}), "SMD 2.01");
    EXPECT_EQ(read(96), 50);
    auto chosen    = usual();
    chosen.version = smd::pv400;
    drive          = smd_drive{chosen};
    auto const old = ask(89, 4);
    EXPECT_EQ((std::string{old.begin() + 2, old.end()}), "SMD 1.51");
    EXPECT_EQ(outcome(ask(95, 4)), 3);
}

TEST_F(SmdDrive, serial_speed_is_between_c10_and_c11)
{
    write(48, 0);
    EXPECT_EQ(write(40, 501), 3);
    EXPECT_EQ(write(60, 600), answered);
    EXPECT_EQ(write(40, 600), answered);
    EXPECT_EQ(write(59, 100), answered);
    EXPECT_EQ(write(40, 99), 3);
}

TEST_F(SmdDrive, broadcasts_and_other_addresses_are_nothing_to_it)
{
    for (int address = 0; address < 248; ++address) {
        if (address == 5) { continue; }
        EXPECT_TRUE(send({6, 0, 48, 0, 0}, low(address)).empty()) << address;
    }
    EXPECT_EQ(drive.lock_state(), smd::lock_state::locked);
}

TEST_F(SmdDrive, other_functions_are_exception_1_and_16_takes_one_register)
{
    for (int function = 1; function < 0x80; ++function) {
        if (function == 3 or function == 4 or function == 6 or function == 16) { continue; }
        EXPECT_EQ(outcome(send({low(function), 0, 24, 0, 1})), 1) << function;
    }
    write(48, 0);
    EXPECT_EQ(write_by_16(61, 100, 2), 3);
    EXPECT_EQ(read(61), 50);
}

TEST_F(SmdDrive, busy_is_exception_6)
{
    write(48, 0);
    drive.set_busy(true);
    EXPECT_EQ(write(61, 100), 6);
    EXPECT_EQ(outcome(ask(24, 6)), 6);
    drive.set_busy(false);
    EXPECT_EQ(read(61), 50);
}

//=== watchdog ===//

TEST_F(SmdDrive, silence_does_what_n22_says)
{
    static constexpr struct {
        int                     n22;
        smd::operational_status soon;
        smd::operational_status later;
        smd::fault              fault;
    } rows[] = {{0, run, run, smd::fault::no_fault},
                {1, inhibit, inhibit, smd::fault::no_fault},
                {2, decel, stop, smd::fault::no_fault},
                {3, smd::operational_status::fault, smd::operational_status::fault, smd::fault::communication_fault}};
    for (auto const& row : rows) {
        SCOPED_TRACE(row.n22);
        drive = smd_drive{usual()};
        run_at(500);
        EXPECT_EQ(write(133, 200), answered);
        EXPECT_EQ(write(132, row.n22), answered);
        pass(0.2);
        EXPECT_EQ(status(), run);
        pass(0.01);
        EXPECT_EQ(status(), row.soon);
        pass(2);
        EXPECT_EQ(status(), row.later);
        EXPECT_EQ(drive.status().fault, row.fault);
        EXPECT_EQ(write(1, 0x0008), row.n22 == 0 ? answered : 1);
    }
}

TEST_F(SmdDrive, whoever_asks_in_time_keeps_it_running)
{
    run_at(500);
    write(133, 200);
    write(132, 3);
    for (int i = 0; i < 100; ++i) {
        pass(0.2);
        EXPECT_EQ(outcome(i % 2 == 0 ? ask(24, 6) : ask(0, 1)), i % 2 == 0 ? answered : 2);
    }
    EXPECT_EQ(status(), run);
}

TEST_F(SmdDrive, time_out_of_parameters_alone_leaves_the_motor)
{
    run_at(500);
    write(133, 200);
    write(132, 3);
    write(1, 0x0002);
    write(49, 0);
    pass(1);
    EXPECT_EQ(status(), run);
    EXPECT_EQ(write(61, 100), 1);
    pass(10);
    EXPECT_EQ(status(), run);  // locked: nobody has to talk to it
}

//=== faults, terminals, mains ===//

TEST_F(SmdDrive, faults_have_a_history_and_are_reset_by_terminal_28)
{
    run_at(500);
    drive.trip(smd::fault::high_drive_temperature);
    drive.trip(smd::fault::earth_fault);
    EXPECT_EQ(status(), smd::operational_status::fault);
    EXPECT_EQ(read(29) >> 8, 2);
    EXPECT_EQ(read(110), 2);
    write(1, 0x0008);
    pass(1);
    EXPECT_EQ(drive.speed(), 0);
    drive.set_terminal_28(false);
    EXPECT_EQ(read(110), 2);
    drive.set_terminal_28(true);
    EXPECT_EQ(status(), off);
    drive.trip(smd::fault::earth_fault);
    drive.power_up();
    EXPECT_EQ(read(110), 0);
    EXPECT_EQ(read(111), 25);
    EXPECT_EQ(read(112), 2);
}

TEST_F(SmdDrive, faults_reset_themselves_with_c70)
{
    write(48, 0);
    write(113, 1);
    write(114, 10);
    drive.trip(smd::fault::low_dc_bus_voltage);
    pass(0.9);
    EXPECT_EQ(read(110), 4);
    pass(0.2);
    EXPECT_EQ(read(110), 0);
}

TEST_F(SmdDrive, terminal_28_stops_the_motor_and_lets_none_start)
{
    run_at(500);
    drive.toggle_terminal_28();
    EXPECT_EQ(status(), inhibit);
    EXPECT_EQ(drive.speed(), 0);
    EXPECT_EQ(write(1, 0x0008), answered);
    drive.toggle_terminal_28();
    pass(1);
    EXPECT_EQ(status(), off);
    write(1, 0x0008);
    pass(1);
    EXPECT_EQ(status(), run);
}

TEST_F(SmdDrive, mains_locks_it_and_keeps_parameters_and_speed)
{
    run_at(300);
    write(1, 0x0040);
    drive.power_up();
    EXPECT_EQ(status(), off);
    EXPECT_EQ(drive.lock_state(), smd::lock_state::locked);
    EXPECT_EQ(drive.status().commanded_direction, smd::direction::forward);
    EXPECT_EQ(read(61), 10);
    EXPECT_EQ(read(40), 300);
}

TEST_F(SmdDrive, address_and_format_are_of_the_next_power_up)
{
    write(48, 0);
    EXPECT_EQ(write(58, 6), answered);
    EXPECT_EQ(write(103, 2), answered);
    EXPECT_EQ(read(58), 6);
    drive.power_up();
    EXPECT_EQ(drive.address(), 6);
    EXPECT_EQ(drive.format(), smd::serial_format::format_8e1);
    EXPECT_TRUE(ask(24, 6).empty());
    EXPECT_FALSE(send({3, 0, 24, 0, 6}, 6).empty());
}

TEST_F(SmdDrive, defaults_are_loaded_at_standstill_only_and_take_modbus_with_them)
{
    run_at(300);
    EXPECT_EQ(write(52, 2), 1);
    write(1, 0x0004);
    EXPECT_EQ(write(52, 3), 3);  // there are no OEM defaults
    EXPECT_EQ(write(52, 4), answered);
    EXPECT_EQ(read(52), 0);
    EXPECT_EQ(read(61), 10);
    EXPECT_EQ(write(52, 2), answered);
    EXPECT_FALSE(drive.speaks_modbus());
    EXPECT_EQ(drive.status().control_mode, smd::control_mode::analog_terminal_keypad);
}

TEST_F(SmdDrive, inputs_choose_presets_while_the_reference_is_local)
{
    write(48, 0);
    write(106, 55);
    write(54, 2);
    EXPECT_EQ(read(24), 55);
    EXPECT_EQ(read(28) >> 8, 1);
    drive.toggle_input(0);
    EXPECT_EQ(read(24), 200);
    EXPECT_EQ(read(28), 0x0201);
    drive.toggle_input(1);
    EXPECT_EQ(read(24), 400);
    EXPECT_EQ(read(28), 0x0401);
    drive.toggle_input(0);
    EXPECT_EQ(read(24), 300);
    write(1, 0x0100);
    EXPECT_EQ(read(28), 0x0600);
    write(1, 0x0008);
    drive.toggle_input(2);
    EXPECT_EQ(status(), dc_brake);
}

TEST_F(SmdDrive, terminals_run_it_in_c01_9)
{
    auto chosen         = usual();
    chosen.control_mode = smd::control_mode::c40_terminal_modbus;
    drive               = smd_drive{chosen};
    write(49, 0);
    write(106, 100);
    pass(5);
    EXPECT_EQ(status(), run);  // by c42
    EXPECT_EQ(drive.status().actual_direction, smd::direction::forward);
    drive.toggle_input(1);
    pass(5);
    EXPECT_EQ(drive.status().actual_direction, smd::direction::reverse);
    drive.set_terminal_28(false);
    EXPECT_EQ(status(), inhibit);
    drive.set_terminal_28(true);
    pass(5);
    EXPECT_EQ(status(), run);
}

//=== the controller at the other end ===//

/// One exchange, with what may happen to frames on a line.
void exchange(smd_drive& drive, smd::controller& control, std::mt19937& random, int losses)
{
    auto const what = control.next();
    if (what.what == smd::step::none) { return; }
    auto const is_lost = [&] { return static_cast<int>(random() % 100) < losses; };

    std::array<std::uint8_t, rtu::max_adu_size> out{};
    std::array<std::uint8_t, rtu::max_adu_size> room{};
    constexpr smd::network_address              address{5};
    auto const                                  tell = [&](auto const& request, auto const& take) {
        auto const adu = rtu::encode(address, request, out);
        auto const frame = rtu::frame{.raw = *adu, .direction = modbus::direction::request, .aligned = true};
        if (is_lost()) { return static_cast<void>(control.lost()); }
        if (is_lost()) { static_cast<void>(drive.answer_frame(frame, room)); }  // it hears it twice
        auto const reply = drive.answer_frame(frame, room);
        if (reply.empty() or is_lost()) { return static_cast<void>(control.lost()); }
        auto const answer = rtu::check(address, request, reply);
        ASSERT_TRUE(answer or answer.error().code() == drivecodec::errc::exception_reply);
        if (not answer) {
            control.refused(smd::to_exception(answer.error().exception()));
        } else {
            take(*answer);
        }
    };
    if (what.is_write()) {
        tell(what.write, [&](auto const& given) {
            control.answered(smd::write_single_register::request{given.address, given.value});
        });
    } else {
        tell(smd::drive_status.read(),
             [&](auto const& given) { control.answered(*smd::drive_status.value(given.values)); });
    }
}

TEST_F(SmdDrive, controller_runs_stops_and_locks_it_on_a_line_that_loses_and_doubles)
{
    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937    random{seed};
        smd::controller control{{.password = 0, .interval = 50'000, .patience = 200}};
        drive = smd_drive{usual()};

        auto const keep_going = [&](auto const& until) {
            for (int i = 0; i < 5000 and not until(); ++i) {
                exchange(drive, control, random, static_cast<int>(seed % 3) * 15);
                drive.go_on(10ms);
                control.pass(10'000);
                // Somebody locks it behind the controller's back.
                if (seed % 2 == 1 and random() % 50 == 0) { write(1, 0x0002); }
            }
            return until();
        };
        ASSERT_TRUE(control.run(smd::direction::reverse, {300, -1}).ok());
        EXPECT_TRUE(keep_going([&] {
            return drive.status().actual_speed == decltype(control.status().actual_speed){300, -1};
        }));
        EXPECT_EQ(drive.status().actual_direction, smd::direction::reverse);
        control.stop();
        EXPECT_TRUE(keep_going([&] { return control.progress() == smd::progress::reached; }));
        EXPECT_EQ(status(), off);
        control.lock();
        EXPECT_TRUE(keep_going([&] { return control.progress() == smd::progress::reached; }));
        EXPECT_EQ(drive.lock_state(), smd::lock_state::locked);
    }
}

}  // namespace
