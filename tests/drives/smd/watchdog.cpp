#include <drivecodec/drives/smd/watchdog.hpp>

#include "support/verify.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::smd;
using namespace drivecodec::literals;
using enum lock_state;
using n22_is   = serial_timeout_action;
using reaction = time_out_reaction;

constexpr locks drive_in(lock_state wanted)
{
    locks drive{control_mode::c40_modbus, 123};
    if (wanted == control or wanted == both) { (void)drive.write(48, 0); }
    if (wanted == parameters or wanted == both) { (void)drive.write(49, 123); }
    return drive;
}

TEST(smd_watchdog, does_what_n22_says_to_a_drive_whose_control_is_unlocked)
{
    for (auto const state : {control, both}) {
        EXPECT_EQ(reaction_to_time_out(n22_is{0}, state), reaction::none);
        EXPECT_EQ(reaction_to_time_out(n22_is{1}, state), reaction::lock_and_inhibit);
        EXPECT_EQ(reaction_to_time_out(n22_is{2}, state), reaction::lock_and_stop);
        EXPECT_EQ(reaction_to_time_out(n22_is{3}, state), reaction::lock_and_trip);
    }
    VERIFY(reaction_to_time_out(n22_is::trip_fault_fc3, control) == reaction::lock_and_trip);
}

TEST(smd_watchdog, does_not_stop_a_drive_of_which_only_parameters_are_unlocked)
{
    VERIFY(reaction_to_time_out(n22_is{0}, parameters) == reaction::none);
    for (std::uint16_t n22 = 1; n22 <= 3; ++n22) {
        EXPECT_EQ(reaction_to_time_out(n22_is{n22}, parameters), reaction::lock);
    }
}

TEST(smd_watchdog, does_not_run_while_locked_or_off_or_set_to_what_is_unknown)
{
    for (unsigned n22 = 0; n22 <= 0xFFFF; ++n22) {
        auto const action = n22_is{static_cast<std::uint16_t>(n22)};
        ASSERT_EQ(reaction_to_time_out(action, locked), reaction::none);
        ASSERT_EQ(reaction_to_time_out(action, both) != reaction::none, n22 >= 1 and n22 <= 3) << n22;
    }
}

TEST(smd_watchdog, bites_after_more_than_n23)
{
    for (auto const limit : {50U, 51U, 1000U, 65535U}) {
        for (auto const state : {control, parameters, both}) {
            auto     drive = drive_in(state);
            watchdog dog{n22_is::quick_stop, static_cast<std::uint16_t>(limit)};
            EXPECT_EQ(dog.pass(limit * 1000, drive), reaction::none);
            EXPECT_EQ(drive.state(), state);
            EXPECT_EQ(dog.pass(1, drive), state == parameters ? reaction::lock : reaction::lock_and_stop);
            EXPECT_EQ(drive.state(), locked);
            EXPECT_EQ(dog.pass(0xFFFFFFFF, drive), reaction::none);  // once
        }
    }
}

TEST(smd_watchdog, begins_anew_with_every_message)
{
    auto     drive = drive_in(control);
    watchdog dog{n22_is::trip_fault_fc3, 50};
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(dog.pass(50'000, drive), reaction::none);
        dog.heard();
    }
    EXPECT_EQ(dog.pass(50'001, drive), reaction::lock_and_trip);
}

TEST(smd_watchdog, counts_nothing_before_something_is_unlocked)
{
    auto     drive = drive_in(locked);
    watchdog dog{n22_is::trip_fault_fc3, 50};
    EXPECT_EQ(dog.pass(0xFFFFFFFF, drive), reaction::none);
    EXPECT_TRUE(drive.write(48, 0));
    EXPECT_EQ(dog.pass(50'000, drive), reaction::none);
    EXPECT_EQ(dog.pass(1, drive), reaction::lock_and_trip);
}

TEST(smd_watchdog, is_stopped_by_the_lock_and_by_n22_0)
{
    auto     drive = drive_in(both);
    watchdog dog{n22_is::trip_fault_fc3, 50};
    EXPECT_TRUE(drive.write(1, 0x0002));
    EXPECT_EQ(dog.pass(0xFFFFFFFF, drive), reaction::none);

    drive = drive_in(both);
    dog.set_action(n22_is::not_active);
    EXPECT_EQ(dog.pass(0xFFFFFFFF, drive), reaction::none);
    EXPECT_EQ(drive.state(), both);
    dog.set_action(n22_is::controller_inhibit);
    dog.set_fault_time(100);
    EXPECT_EQ(dog.pass(100'000, drive), reaction::none);
    EXPECT_EQ(dog.pass(1, drive), reaction::lock_and_inhibit);
}

TEST(smd_watchdog, is_off_as_a_drive_leaves_the_factory)
{
    auto     drive = drive_in(both);
    watchdog dog;
    EXPECT_EQ(dog.pass(0xFFFFFFFF, drive), reaction::none);
    dog.set_action(n22_is::quick_stop);
    EXPECT_EQ(dog.pass(50'000, drive), reaction::none);
    EXPECT_EQ(dog.pass(1, drive), reaction::lock_and_stop);
}

TEST(smd_watchdog, adds_up_time_in_pieces_of_any_length)
{
    std::mt19937 random{23};
    for (int run = 0; run < 500; ++run) {
        auto const    limit = static_cast<std::uint16_t>(50 + random() % 65486);
        auto          drive = drive_in(control);
        watchdog      dog{n22_is::quick_stop, limit};
        std::uint64_t silence = 0;
        while (drive.state() == control) {
            auto const piece = static_cast<std::uint32_t>(random() % 20'000'000);
            silence += piece;
            auto const bites = dog.pass(piece, drive) != reaction::none;
            ASSERT_EQ(bites, silence > limit * std::uint64_t{1000});
        }
    }
}

TEST(smd_keep_alive, is_less_than_half_of_n23)
{
    VERIFY(*keep_alive_interval(100_ms, 40'000) == 49'999);
    VERIFY(*keep_alive_interval(65.535_s, 40'000) == 32'767'499);
    VERIFY(not keep_alive_interval(49_ms, 0) and not keep_alive_interval(65.536_s, 0));
    VERIFY(not keep_alive_interval(80_ms, 40'000) and keep_alive_interval(80_ms, 39'999));
}

//=== where the manual contradicts itself ===//

TEST(smd_keep_alive, at_the_50_ms_of_the_factory_cannot_be_done_by_one_status_poll_of_36_7_ms)
{
    // 8 + 17 characters and two silences of 3.5, of 11 bits each, at 9600 bits per second
    constexpr auto line = *modbus::rtu::timing::make(9600, modbus::rtu::format_8n2);
    EXPECT_EQ((status_poll_time(line) + 50) / 100, 367);
    VERIFY(keep_alive_interval(factory_fault_time, status_poll_time(line)).error().code() == errc::out_of_range);
    VERIFY(keep_alive_interval(74_ms, status_poll_time(line)).has_value());
}

TEST(smd_watchdog, trips_fc3_which_is_24_and_not_fc5)
{
    VERIFY(reaction_to_time_out(n22_is::trip_fault_fc3, both) == reaction::lock_and_trip);
    VERIFY(static_cast<int>(fault::communication_fault) == 24);
    VERIFY(is_communication(fault{8}) and is_communication(fault{24}));
}

}  // namespace
