#include <drivecodec/drives/smd/controller.hpp>

#include "drives/smd/small_drive.hpp"
#include "support/verify.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace {

using namespace drivecodec;
using namespace drivecodec::smd;
using namespace drivecodec::literals;
using enum progress;

/// Both ends of a line.
struct line {
    controller                 master;
    small_drive                drive{};
    std::vector<std::uint32_t> sent{};  // address << 16 | value; 24 << 16 for a poll

    explicit line(controller::settings chosen = {}) : master{chosen} {}

    void wait_until_due()
    {
        auto const due = master.due_in();
        if (due == controller::never) { return; }
        master.pass(due);
        drive.pass(due);
    }
    exchange ask()
    {
        wait_until_due();
        auto const asked = master.next();
        if (asked.what != step::none) {
            sent.push_back(asked.is_write() ? std::uint32_t{asked.write.address} << 16 | asked.write.value : 24U << 16);
        }
        return asked;
    }
    enum class fate { arrives, request_lost, reply_lost, doubled };

    progress once(fate what = fate::arrives)
    {
        auto const asked = ask();
        if (asked.what == step::none) { return master.progress(); }
        if (what == fate::request_lost) { return master.lost(); }
        if (not asked.is_write()) {
            auto const status = drive.poll();
            if (what == fate::reply_lost) { return master.lost(); }
            (void)master.answered(status);
            return what == fate::doubled ? master.answered(status) : master.progress();
        }
        auto code = drive.receive(asked.write);
        if (what == fate::doubled) { code = drive.receive(asked.write); }
        if (what == fate::reply_lost) { return master.lost(); }
        for (int i = 0; i < (what == fate::doubled ? 2 : 1); ++i) {
            if (code == 0) {
                (void)master.answered(asked.write);
            } else {
                (void)master.refused(static_cast<exception>(code));
            }
        }
        return master.progress();
    }
    progress settle(int most = 200)
    {
        do {
            (void)once();
        } while (master.progress() == waiting and --most > 0);
        return master.progress();
    }
    line& running(direction way = direction::forward)
    {
        EXPECT_TRUE(master.run(way, 41.2_Hz).ok());
        EXPECT_EQ(settle(), reached);
        EXPECT_TRUE(drive.is_running);
        sent.clear();
        return *this;
    }
};

using wire = std::vector<std::uint32_t>;

constexpr std::uint32_t poll         = 0x00180000;
constexpr std::uint32_t unlock       = 0x00300000;
constexpr std::uint32_t serial_speed = 0x00010100;
constexpr std::uint32_t speed_41_2   = 0x0028019C;
constexpr std::uint32_t set_forward  = 0x00010080;
constexpr std::uint32_t set_reverse  = 0x00010040;
constexpr std::uint32_t start        = 0x00010008;
constexpr std::uint32_t stop         = 0x00010004;
constexpr std::uint32_t lock         = 0x00010002;

TEST(smd_controller, only_watches_without_a_goal)
{
    line both;
    for (int i = 0; i < 20; ++i) { EXPECT_EQ(both.once(), reached); }
    EXPECT_EQ(both.sent, wire(20, poll));
}

TEST(smd_controller, runs_by_the_sequence_of_4_8)
{
    line both;
    ASSERT_TRUE(both.master.run(direction::forward, 41.2_Hz).ok());
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(both.sent, (wire{poll, unlock, serial_speed, speed_41_2, set_forward, poll, start, poll}));
    EXPECT_TRUE(both.drive.is_running);
    EXPECT_EQ(both.drive.starts, 1);
}

/// The steps that a drive is asked for which does all at once.
constexpr std::array<step, 7> steps_to_run()
{
    controller   master;
    status_block status{.operational_status = operational_status::stop, .control_mode = control_mode::c40_modbus};
    std::array<step, 7> asked{};
    (void)master.run(direction::forward, 41.2_Hz);
    for (auto& what : asked) {
        auto const now = master.next();
        what           = now.what;
        if (now.is_write()) {
            (void)master.answered(now.write);
        } else {
            (void)master.answered(status);
        }
    }
    return asked;
}

TEST(smd_controller, runs_at_compile_time)
{
    using enum step;
    VERIFY(steps_to_run()
           == std::array{poll_status, unlock, set_reference, set_speed, set_direction, poll_status, step::start});
}

TEST(smd_controller, sends_the_password_that_it_is_given)
{
    line both{{.password = 123}};
    both.drive.locks.set_password(123);
    both.running(direction::reverse);
    EXPECT_EQ(both.drive.locks.state(), lock_state::both);
    EXPECT_TRUE(both.drive.is_reverse);
}

TEST(smd_controller, changes_only_what_changes_while_it_runs)
{
    line both;
    both.running();
    ASSERT_TRUE(both.master.run(direction::reverse, 41.2_Hz).ok());
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(both.sent, (wire{set_reverse, poll}));
    both.sent.clear();
    ASSERT_TRUE(both.master.run(direction::reverse, 10_Hz).ok());
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(both.sent, (wire{0x00280064, poll}));
    both.sent.clear();
    ASSERT_TRUE(both.master.run(direction::reverse, 10_Hz).ok());
    EXPECT_EQ(both.master.progress(), reached);
    EXPECT_EQ(both.drive.starts, 1);
}

TEST(smd_controller, refuses_speeds_that_register_40_does_not_take_and_keeps_its_goal)
{
    line both;
    both.running();
    EXPECT_EQ(both.master.run(direction::forward, 41.25_Hz).code(), errc::inexact);
    EXPECT_EQ(both.master.run(direction::forward, 240.1_Hz).code(), errc::out_of_range);
    EXPECT_EQ(both.master.run(direction{2}, 40_Hz).code(), errc::bad_value);
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(both.sent, wire{poll});
}

TEST(smd_controller, stops_at_once_from_anywhere)
{
    for (int before = 0; before < 12; ++before) {
        for (bool const outstanding : {false, true}) {
            line both;
            ASSERT_TRUE(both.master.run(direction::forward, 41.2_Hz).ok());
            for (int i = 0; i < before; ++i) { (void)both.once(); }
            if (outstanding) { (void)both.ask(); }
            both.sent.clear();
            both.master.stop();
            EXPECT_EQ(both.master.due_in(), 0);
            (void)both.once();
            EXPECT_EQ(both.sent, wire{stop});
            EXPECT_EQ(both.master.progress() == waiting ? both.settle() : both.master.progress(), reached);
            EXPECT_FALSE(both.drive.is_running);
        }
    }
}

TEST(smd_controller, stops_before_it_locks_and_then_is_silent)
{
    line both;
    both.running().master.lock();
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(both.sent, (wire{stop, poll, lock}));
    EXPECT_EQ(both.drive.locks.state(), lock_state::locked);
    EXPECT_EQ(both.master.due_in(), controller::never);
    EXPECT_EQ(both.master.next().what, step::none);
}

TEST(smd_controller, finds_a_locked_drive_stopped_and_locked_without_unlocking_it)
{
    line both;
    both.master.stop();
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(both.sent, (wire{stop, poll}));
    both.sent.clear();
    both.master.lock();
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(both.sent, (wire{stop, poll, lock}));
}

TEST(smd_controller, unlocks_a_running_drive_to_stop_it)
{
    line both;
    both.drive.is_running = true;
    both.master.stop();
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(both.sent, (wire{stop, poll, unlock, stop, poll}));
    EXPECT_FALSE(both.drive.is_running);
}

TEST(smd_controller, stops_again_what_somebody_else_has_started)
{
    line both;
    both.running().master.stop();
    EXPECT_EQ(both.settle(), reached);
    both.drive.is_running = true;
    EXPECT_EQ(both.once(), waiting);
    EXPECT_EQ(both.settle(), reached);
    EXPECT_FALSE(both.drive.is_running);
}

TEST(smd_controller, polls_at_its_interval_and_asks_one_thing_at_a_time)
{
    line both{{.interval = 40'000}};
    both.running();
    EXPECT_EQ(both.master.due_in(), 40'000);
    both.master.pass(39'999);
    EXPECT_EQ(both.master.due_in(), 1);
    EXPECT_EQ(both.master.next().what, step::none);
    both.master.pass(1);
    EXPECT_EQ(both.master.next().what, step::poll_status);
    EXPECT_EQ(both.master.due_in(), controller::never);
    EXPECT_EQ(both.master.next().what, step::none);
    both.master.pass(0xFFFFFFFF);
    both.master.pass(0xFFFFFFFF);
    EXPECT_EQ(both.master.next().what, step::none);
    EXPECT_EQ(both.master.answered(both.drive.poll()), reached);
    EXPECT_EQ(both.master.next().what, step::poll_status);
}

TEST(smd_controller, keeps_the_watchdog_quiet)
{
    for (std::uint16_t n22 = 1; n22 <= 3; ++n22) {
        line both{{.interval = *keep_alive_interval(100_ms, 36'667)}};
        both.drive.watchdog = {serial_timeout_action{n22}, 100};
        both.running();
        for (int i = 0; i < 1000; ++i) { ASSERT_EQ(both.once(), reached); }
        EXPECT_EQ(both.drive.starts, 1);
    }
}

TEST(smd_controller, unlocks_and_starts_again_after_a_time_out_that_stopped_or_inhibited)
{
    for (std::uint16_t n22 = 1; n22 <= 2; ++n22) {
        line both;
        both.drive.watchdog = {serial_timeout_action{n22}, 1000};
        both.running();
        both.drive.pass(1'000'001);
        EXPECT_FALSE(both.drive.is_running);
        (void)both.once();
        EXPECT_EQ(both.settle(), reached);
        EXPECT_EQ(both.sent,
                  (wire{poll, speed_41_2, poll, unlock, serial_speed, speed_41_2, set_forward, poll, start, poll}));
        EXPECT_TRUE(both.drive.is_running);
        EXPECT_EQ(both.drive.starts, 2);
    }
}

TEST(smd_controller, reports_the_trip_of_a_time_out_as_fault_24)
{
    line both;
    both.drive.watchdog = {serial_timeout_action::trip_fault_fc3, 1000};
    both.running();
    both.drive.pass(1'000'001);
    EXPECT_EQ(both.settle(), faulted);
    EXPECT_EQ(static_cast<int>(both.master.status().fault), 24);
    both.drive.fault = fault::no_fault;
    for (int i = 0; i < 20; ++i) { EXPECT_EQ(both.once(), faulted); }  // somebody has to set the goal again
    EXPECT_FALSE(both.drive.is_running);
    both.running();
}

TEST(smd_controller, does_not_restart_what_somebody_stopped)
{
    line both;
    both.running();
    both.drive.is_running = false;
    EXPECT_EQ(both.settle(), refused);
    EXPECT_EQ(both.master.why(), refusal::stopped_elsewhere);
    for (int i = 0; i < 20; ++i) { EXPECT_EQ(both.once(), refused); }
    EXPECT_EQ(both.drive.starts, 1);
}

TEST(smd_controller, does_not_restart_when_terminal_28_closes_again)
{
    line both;
    both.running();
    both.drive.open_terminal_28();
    EXPECT_EQ(both.settle(), refused);
    EXPECT_EQ(both.master.why(), refusal::inhibited);
    both.drive.terminal_28 = true;
    for (int i = 0; i < 20; ++i) { EXPECT_EQ(both.once(), refused); }
    EXPECT_EQ(both.drive.starts, 1);
    both.running();
}

TEST(smd_controller, does_not_start_while_terminal_28_is_open)
{
    line both;
    both.drive.open_terminal_28();
    ASSERT_TRUE(both.master.run(direction::forward, 41.2_Hz).ok());
    EXPECT_EQ(both.settle(), refused);
    EXPECT_EQ(both.master.why(), refusal::inhibited);
    EXPECT_EQ(both.sent, wire{poll});
}

TEST(smd_controller, controls_only_with_c01_at_10_or_11)
{
    for (std::uint16_t mode = 0; mode <= 255; ++mode) {
        line both;
        both.drive.set_c01(control_mode{mode});
        ASSERT_TRUE(both.master.run(direction::forward, 41.2_Hz).ok());
        auto const allowed = mode == 10 or mode == 11;
        ASSERT_EQ(both.settle(), allowed ? reached : refused) << mode;
        ASSERT_EQ(both.master.why(), allowed ? refusal::none : refusal::no_serial_control);
        both.drive.set_c01(control_mode::analog_terminal_modbus);
        ASSERT_EQ(both.settle(), refused);
        ASSERT_EQ(both.master.why(), refusal::no_serial_control);
        both.drive.is_running = true;  // by its terminals
        both.master.stop();
        ASSERT_EQ(both.settle(), refused);
        ASSERT_EQ(both.master.why(), refusal::no_serial_control);
        both.master.lock();
        ASSERT_EQ(both.settle(), reached);
    }
}

TEST(smd_controller, says_that_the_password_is_wrong)
{
    line both{{.password = 5}};
    ASSERT_TRUE(both.master.run(direction::forward, 41.2_Hz).ok());
    EXPECT_EQ(both.settle(), refused);
    EXPECT_EQ(both.master.why(), refusal::unlock_rejected);
}

TEST(smd_controller, says_that_a_speed_is_outside_c10_and_c11)
{
    line both;
    ASSERT_TRUE(both.master.run(direction::forward, 60_Hz).ok());  // C11 is 50 Hz
    EXPECT_EQ(both.settle(), refused);
    EXPECT_EQ(both.master.why(), refusal::out_of_range);
    EXPECT_EQ(both.drive.starts, 0);
}

TEST(smd_controller, sends_start_once_to_a_drive_that_does_not_start)
{
    line both;
    both.drive.deaf_to_start = true;
    ASSERT_TRUE(both.master.run(direction::forward, 41.2_Hz).ok());
    EXPECT_EQ(both.settle(), refused);
    EXPECT_EQ(both.master.why(), refusal::not_followed);
    EXPECT_EQ(std::count(both.sent.begin(), both.sent.end(), start), 1);
}

TEST(smd_controller, looks_before_it_starts_again_if_the_reply_was_lost)
{
    line both;
    ASSERT_TRUE(both.master.run(direction::forward, 41.2_Hz).ok());
    for (int i = 0; i < 6; ++i) { (void)both.once(); }
    EXPECT_EQ(both.once(line::fate::reply_lost), waiting);
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(std::count(both.sent.begin(), both.sent.end(), start), 1);
}

TEST(smd_controller, is_as_patient_as_it_is_told_with_a_silent_or_busy_drive)
{
    for (auto const patience : std::array<std::uint16_t, 4>{0, 1, 10, 1000}) {
        for (bool const is_busy : {false, true}) {
            for (int goal = 0; goal < 4; ++goal) {
                line both{{.patience = patience}};
                if (goal == 1) { both.master.stop(); }
                if (goal == 2) { both.master.lock(); }
                if (goal == 3) { ASSERT_TRUE(both.master.run(direction::forward, 1_Hz).ok()); }
                for (int i = 0; i < patience + 20; ++i) {
                    ASSERT_NE(both.ask().what, step::none);
                    auto const says = is_busy ? both.master.refused(exception::slave_device_busy) : both.master.lost();
                    ASSERT_EQ(says, i < patience ? waiting : refused) << i;
                }
                EXPECT_EQ(both.master.why(), is_busy ? refusal::busy : refusal::no_reply);
            }
        }
    }
}

TEST(smd_controller, goes_on_stopping_after_it_has_lost_patience)
{
    line both;
    both.running().master.stop();
    for (int i = 0; i < 50; ++i) { (void)both.once(line::fate::request_lost); }
    EXPECT_EQ(both.master.progress(), refused);
    EXPECT_EQ(both.sent, wire(50, stop));
    (void)both.once();
    (void)both.once();
    EXPECT_EQ(both.master.progress(), reached);
    EXPECT_FALSE(both.drive.is_running);
}

TEST(smd_controller, ignores_what_answers_nothing)
{
    line both;
    ASSERT_TRUE(both.master.run(direction::forward, 41.2_Hz).ok());
    (void)both.once();
    auto const asked = both.ask();
    ASSERT_EQ(asked.what, step::unlock);
    EXPECT_EQ(both.master.answered(both.drive.poll()), waiting);
    EXPECT_EQ(both.master.answered(modbus::write_single_register::request{48, 1}), waiting);
    EXPECT_EQ(both.master.answered(modbus::write_single_register::request{1, 0}), waiting);
    EXPECT_EQ(both.master.next().what, step::none);
    EXPECT_EQ(both.master.answered(asked.write), waiting);
    EXPECT_EQ(both.master.answered(asked.write), waiting);
    EXPECT_EQ(both.master.refused(exception::command_rejected), waiting);
    EXPECT_EQ(both.master.lost(), waiting);
    EXPECT_EQ(both.settle(), reached);
}

TEST(smd_controller, unlocks_once_for_several_goals)
{
    line both;
    both.running().master.stop();
    EXPECT_EQ(both.settle(), reached);
    both.sent.clear();
    ASSERT_TRUE(both.master.run(direction::forward, 41.2_Hz).ok());
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(both.sent, (wire{poll, serial_speed, speed_41_2, set_forward, poll, start, poll}));
}

TEST(smd_controller, does_not_take_terminal_28_for_a_time_out_that_is_over)
{
    line both;
    both.running();
    both.drive.locks.lock();
    both.drive.is_running = false;
    (void)both.once();
    EXPECT_EQ(both.settle(), reached);
    both.drive.open_terminal_28();
    (void)both.once();
    EXPECT_EQ(both.settle(), refused);
    EXPECT_EQ(both.master.why(), refusal::inhibited);
    EXPECT_EQ(both.drive.starts, 2);
}

TEST(smd_controller, sends_the_new_speed_though_the_old_one_is_outstanding)
{
    line both;
    both.running();
    ASSERT_TRUE(both.master.run(direction::forward, 20_Hz).ok());
    auto const old = both.ask();
    ASSERT_EQ(old.what, step::set_speed);
    ASSERT_TRUE(both.master.run(direction::forward, 10_Hz).ok());
    EXPECT_EQ(both.master.due_in(), 0);
    EXPECT_EQ(both.master.answered(old.write), waiting);
    EXPECT_EQ(both.settle(), reached);
    EXPECT_EQ(both.drive.speed, 100);
}

//=== everything that can happen, at every step ===//

TEST(smd_controller, gets_there_whatever_happens_once_at_any_step)
{
    for (int at = 0; at < 14; ++at) {
        for (int what = 0; what < 9; ++what) {
            line both{{.interval = 40'000}};
            both.drive.watchdog = {serial_timeout_action{static_cast<std::uint16_t>(1 + what % 2)}, 100};
            ASSERT_TRUE(both.master.run(direction::reverse, 41.2_Hz).ok());
            for (int i = 0; i < 14; ++i) {
                if (i == at and what == 3) { both.drive.locks.lock(); }
                if (i == at and (what == 4 or what == 5)) { both.drive.pass(100'001); }
                if (i == at and what == 6) { both.drive.power_cycle(); }
                if (i == at and what == 7 and both.ask().what != step::none) {
                    (void)both.master.refused(exception::slave_device_busy);
                    continue;
                }
                using enum line::fate;
                (void)both.once(i != at     ? arrives
                                : what == 0 ? request_lost
                                : what == 1 ? reply_lost
                                : what == 2 ? doubled
                                            : arrives);
            }
            EXPECT_EQ(both.settle(), reached) << at << ' ' << what;
            EXPECT_TRUE(both.drive.is_running and both.drive.is_reverse and both.drive.was_set_up) << at << ' ' << what;
            EXPECT_LE(both.drive.starts, 2);
            both.master.lock();
            EXPECT_EQ(both.settle(), reached);
            EXPECT_TRUE(not both.drive.is_running and both.drive.locks.state() == lock_state::locked);
        }
    }
}

TEST(smd_controller, ends_in_success_or_a_clear_error_over_random_lines)
{
    std::mt19937                           random{48};
    std::set<std::pair<progress, refusal>> ends;
    for (int run = 0; run < 5000; ++run) {
        line both{{.interval = 40'000, .patience = static_cast<std::uint16_t>(random() % 12)}};
        both.drive.watchdog    = {serial_timeout_action{static_cast<std::uint16_t>(random() % 4)}, 100};
        auto       wants_motor = false;
        auto const trouble     = random() % 12;
        for (int i = 0; i < 60; ++i) {
            switch (random() % 40) {
            case 0:
                both.master.stop();
                wants_motor = false;
                break;
            case 1:
                both.master.lock();
                wants_motor = false;
                break;
            case 2:
            case 3:
                ASSERT_TRUE(both.master.run(random() % 2 == 0 ? direction::forward : direction::reverse, 41.2_Hz).ok());
                wants_motor = true;
                break;
            case 4: both.drive.pass(100'001); break;
            case 5: both.drive.locks.lock(); break;
            case 6:
                if (trouble == 1) { both.drive.open_terminal_28(); }
                break;
            case 7:
                if (trouble == 2) { both.drive.set_c01(control_mode::c40_terminal_modbus); }
                break;
            case 8:
                if (trouble == 3) {
                    both.drive.fault      = fault::external_fault;
                    both.drive.is_running = false;
                }
                break;
            case 9:
                both.drive.terminal_28 = true;
                both.drive.fault       = fault::no_fault;
                break;
            case 10: both.drive.power_cycle(); break;
            default: break;
            }
            auto const starts = both.drive.starts;
            auto const kind   = random() % 8;
            (void)both.once(kind < 4 ? static_cast<line::fate>(kind) : line::fate::arrives);
            ASSERT_TRUE(wants_motor or starts == both.drive.starts);
            ASSERT_TRUE(both.drive.starts == 0 or both.drive.was_set_up or both.drive.writes_of_setup == 7);
        }
        auto const says = both.master.progress() == waiting ? both.settle() : both.master.progress();
        ASSERT_NE(says, waiting);
        ends.insert({says, both.master.why()});
        ASSERT_EQ(both.master.why() == refusal::none, says != refused);
        for (int i = 0; i < 3; ++i) { (void)both.once(); }
        if (both.master.progress() == reached) { ASSERT_EQ(both.drive.is_running, wants_motor); }
        both.master.stop();
        (void)both.settle();
        ASSERT_FALSE(both.drive.is_running);
    }
    EXPECT_GE(ends.size(), 5);
}

//=== where the manual contradicts itself ===//

TEST(smd_controller, a_drive_that_wants_parameter_writes_for_the_speed_is_reported_as_locked)
{
    line both;
    ASSERT_TRUE(both.master.run(direction::forward, 41.2_Hz).ok());
    int exchanges = 0;
    while (both.master.progress() == waiting and ++exchanges < 200) {
        auto const asked = both.ask();
        if (asked.what == step::set_speed) {
            (void)both.master.refused(exception::command_rejected);
        } else if (asked.is_write()) {
            (void)both.master.answered(asked.write);
        } else {
            (void)both.master.answered(both.drive.poll());
        }
    }
    EXPECT_EQ(both.master.progress(), refused);
    EXPECT_EQ(both.master.why(), refusal::locked);
}

TEST(smd_controller, exceptions_mean_what_this_drive_means_by_them)
{
    for (unsigned code = 0; code <= 255; ++code) {
        line both;
        both.running();
        ASSERT_TRUE(both.master.run(direction::forward, 10_Hz).ok());
        ASSERT_EQ(both.ask().what, step::set_speed);
        auto const says = both.master.refused(to_exception(static_cast<modbus::exception_code>(code)));
        ASSERT_EQ(says, code == 1 or code == 6 ? waiting : refused) << code;
        ASSERT_EQ(both.master.why(), code == 1 or code == 6 ? refusal::none
                                     : code == 2            ? refusal::no_such_register
                                     : code == 3            ? refusal::out_of_range
                                     : code == 4            ? refusal::wrong_format
                                                            : refusal::unknown_exception);
    }
}

TEST(smd_controller, never_sends_several_bits)
{
    std::mt19937 random{2};
    line         both;
    for (int i = 0; i < 20'000; ++i) {
        auto const choice = random() % 16;
        if (choice == 0) { both.master.stop(); }
        if (choice == 1) { both.master.lock(); }
        if (choice <= 4 and choice >= 2) {
            (void)both.master.run(direction{static_cast<std::uint8_t>(choice % 2)}, 5_Hz);
        }
        (void)both.once(static_cast<line::fate>(random() % 4));
    }
    for (auto const request : both.sent) {
        if (request >> 16 == 1) { ASSERT_TRUE(decode_command(static_cast<std::uint16_t>(request))); }
    }
}

TEST(smd_controller, a_drive_that_ramps_down_to_a_stop_is_started_and_not_taken_for_a_running_one)
{
    using enum operational_status;
    auto const status_of = [](operational_status now, quantity<unit::hertz> actual) {
        status_block made;
        made.command_speed      = {200, -1};
        made.actual_speed       = actual;
        made.operational_status = now;
        made.control_mode       = control_mode::c40_modbus;
        made.speed_reference    = speed_reference::serial;
        return made;
    };
    controller control;
    ASSERT_TRUE(control.run(direction::forward, {200, -1}).ok());
    auto slows   = status_of(decel, {200, -1});
    bool started = false;
    for (int exchanges = 0; exchanges < 12 and not started; ++exchanges) {
        control.pass(500'000);
        auto const asked = control.next();
        EXPECT_NE(control.progress(), progress::reached);
        started = asked.what == step::start;
        if (asked.is_write()) {
            static_cast<void>(control.answered(asked.write));
        } else {
            static_cast<void>(control.answered(slows));
            slows.actual_speed.number -= 10;
        }
    }
    EXPECT_TRUE(started);
    control.pass(500'000);
    EXPECT_EQ(control.next().what, step::poll_status);
    EXPECT_EQ(control.answered(slows), progress::waiting);  // it has not followed yet
    control.pass(500'000);
    EXPECT_EQ(control.next().what, step::poll_status);
    EXPECT_EQ(control.answered(status_of(accel, {150, -1})), progress::reached);
}

}  // namespace
