#include <drivecodec/drives/smd/locks.hpp>
#include <drivecodec/drives/smd/parameters.hpp>

#include "support/verify.hpp"

#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace drivecodec::smd;
using enum lock_state;

constexpr std::uint16_t lock_word = 0x0002;
constexpr auto          serial    = control_mode{11};

/// A drive, and how it answers to one write after the other.
struct written {
    locks drive;

    constexpr written(unsigned password, unsigned c01 = 11)
        : drive{control_mode{static_cast<std::uint16_t>(c01)}, static_cast<std::uint16_t>(password)}
    {}
    constexpr written& write(unsigned address, unsigned value)
    {
        (void)drive.write(static_cast<std::uint16_t>(address), static_cast<std::uint16_t>(value));
        return *this;
    }
};

constexpr lock_state state_after(unsigned password, unsigned address, unsigned value, unsigned c01 = 11)
{
    return written{password, c01}.write(address, value).drive.state();
}

constexpr locks drive_in(lock_state wanted)
{
    written drive{123};
    if (wanted == control or wanted == both) { drive.write(48, 0); }
    if (wanted == parameters or wanted == both) { drive.write(49, 123); }
    return drive.drive;
}

TEST(smd_locks, are_locked_after_power_up)
{
    for (unsigned c01 = 0; c01 <= 11; ++c01) { EXPECT_EQ((written{0, c01}).drive.state(), locked); }
    VERIFY(locks{serial, 0}.state() == locked);
}

TEST(smd_locks, open_by_registers_48_and_49_as_in_4_5_and_4_6)
{
    // C94 = 123
    VERIFY(state_after(123, 48, 0) == control);
    VERIFY(state_after(123, 48, 123) == both);
    VERIFY(state_after(123, 49, 123) == parameters);
    VERIFY(state_after(123, 49, 0) == locked);
    VERIFY(state_after(123, 48, 124) == locked);
    VERIFY(state_after(123, 48, 0, 10) == control);
    VERIFY(state_after(123, 48, 0, 9) == locked);
    VERIFY(state_after(123, 48, 123, 8) == locked);
    VERIFY(state_after(123, 49, 123, 8) == parameters);
}

TEST(smd_locks, open_everything_with_0_while_the_password_is_that_of_the_factory)
{
    VERIFY(state_after(0, 48, 0) == both);
    VERIFY(state_after(0, 49, 0) == parameters);
    for (unsigned password = 1; password <= 999; ++password) { ASSERT_EQ(state_after(password, 48, 0), control); }
}

TEST(smd_locks, take_no_other_password)
{
    for (unsigned value = 0; value <= 0xFFFF; ++value) {
        ASSERT_EQ(state_after(123, 48, value), value == 0 ? control : value == 123 ? both : locked) << value;
        ASSERT_EQ(state_after(123, 49, value), value == 123 ? parameters : locked) << value;
    }
}

TEST(smd_locks, stay_as_they_are_after_a_wrong_password)
{
    for (auto const state : {locked, control, parameters, both}) {
        auto const before = drive_in(state);
        ASSERT_EQ(before.state(), state);
        for (auto const address : {std::uint16_t{48}, std::uint16_t{49}}) {
            auto drive = before;
            EXPECT_FALSE(drive.may_write(address, 124));
            EXPECT_FALSE(drive.write(address, 124));
            EXPECT_EQ(drive, before);
        }
    }
}

/// The states in which each register can be written: smd manual, 4.5 and 4.6.
struct printed_row {
    unsigned             address;
    unsigned             value;
    std::set<lock_state> allowed;
};

TEST(smd_locks, let_pass_what_the_manual_says)
{
    std::set<lock_state> const any{locked, control, parameters, both};
    std::vector<printed_row>   table{
          {1, 0x0001, {control, both}},
          {1, 0x0002, {control, parameters, both}},
          {1, 0x0004, {control, both}},
          {1, 0x0008, {control, both}},
          {1, 0x0040, {control, both}},
          {1, 0x0080, {control, both}},
          {1, 0x0100, {control, both}},
          {1, 0x0200, {control, both}},
          {1, 0x0003, {control, both}},
          {1, 0x0006, {control, both}},
          {40, 412, {control, parameters, both}},
          {48, 0, any},
          {48, 123, any},
          {49, 123, any},
    };
    for (unsigned address = 51; address <= 255; ++address) { table.push_back({address, 50, {parameters, both}}); }
    for (auto const& row : table) {
        for (auto const state : {locked, control, parameters, both}) {
            auto const drive = drive_in(state);
            EXPECT_EQ(drive.may_write(static_cast<std::uint16_t>(row.address), static_cast<std::uint16_t>(row.value)),
                      row.allowed.contains(state))
                << row.address << ' ' << row.value << ' ' << static_cast<int>(state);
        }
    }
}

TEST(smd_locks, close_by_the_lock_bit_from_every_unlocked_state)
{
    for (auto const state : {control, parameters, both}) {
        auto drive = drive_in(state);
        EXPECT_TRUE(drive.write(1, lock_word));
        EXPECT_EQ(drive.state(), locked);
        EXPECT_FALSE(drive.write(1, lock_word));  // a write to a locked drive
    }
}

TEST(smd_locks, close_by_no_other_word_of_register_1)
{
    for (auto const state : {locked, control, parameters, both}) {
        for (unsigned word = 0; word <= 0xFFFF; ++word) {
            auto drive = drive_in(state);
            (void)drive.write(1, static_cast<std::uint16_t>(word));
            ASSERT_EQ(drive.state(), word == lock_word ? locked : state) << word;
        }
    }
}

TEST(smd_locks, unlocking_never_takes_away)
{
    VERIFY(written{123}.write(49, 123).write(48, 0).drive.state() == both);
    VERIFY(written{123}.write(48, 123).write(48, 0).drive.state() == both);
    VERIFY(written{123}.write(48, 0).write(49, 123).drive.state() == both);
    VERIFY(written{123}.write(48, 123).write(49, 123).drive.state() == both);
}

TEST(smd_locks, end_what_48_unlocked_when_c01_leaves_10_and_11)
{
    for (unsigned c01 = 0; c01 <= 0xFFFF; ++c01) {
        auto const stays = c01 == 10 or c01 == 11;
        auto const mode  = control_mode{static_cast<std::uint16_t>(c01)};
        auto       by_48 = written{123}.write(48, 123).drive;
        auto       by_49 = written{123}.write(49, 123).drive;
        auto       all   = written{123}.write(49, 123).write(48, 123).drive;
        for (auto* drive : {&by_48, &by_49, &all}) { drive->set_control_mode(mode); }
        ASSERT_EQ(by_48.state(), stays ? both : locked) << c01;
        ASSERT_EQ(by_49.state(), parameters) << c01;
        ASSERT_EQ(all.state(), stays ? both : parameters) << c01;
    }
    auto drive = written{123}.write(48, 123).drive;
    drive.set_control_mode(control_mode{0});
    drive.set_control_mode(serial);
    EXPECT_EQ(drive.state(), locked);  // and stays so
}

TEST(smd_locks, close_all_at_once_at_power_down_and_time_out)
{
    for (auto const state : {locked, control, parameters, both}) {
        auto drive = drive_in(state);
        drive.lock();
        EXPECT_EQ(drive, drive_in(locked));
    }
}

TEST(smd_locks, ask_for_a_new_password_from_the_next_unlocking_on)
{
    auto drive = written{0}.write(48, 0).drive;
    drive.set_password(7);
    EXPECT_EQ(drive.state(), both);
    drive.lock();
    EXPECT_TRUE(drive.write(48, 0));
    EXPECT_EQ(drive.state(), control);
    EXPECT_FALSE(drive.write(49, 0));
    EXPECT_TRUE(drive.write(49, 7));
    EXPECT_EQ(drive.state(), both);
}

//=== where the manual contradicts itself ===//

TEST(smd_locks, the_password_0_of_the_factory_is_also_the_word_that_unlocks_control_only)
{
    VERIFY(written{0}.write(48, 0).drive.may_write(C12<pv507>.address(), 50));
    VERIFY(not written{1}.write(48, 0).drive.may_write(C12<pv507>.address(), 50));
}

TEST(smd_locks, the_speed_of_register_40_needs_control_and_no_enabled_parameter_writes)
{
    VERIFY(written{123}.write(48, 0).drive.may_write(40, 412));
    VERIFY(not locks{serial, 123}.may_write(40, 412));
}

TEST(smd_locks, register_1_is_closed_to_register_49_but_for_the_lock_that_ends_its_session)
{
    VERIFY(not written{123}.write(49, 123).drive.may_write(1, 0x0004));
    VERIFY(written{123}.write(49, 123).drive.may_write(1, lock_word));
}

//=== against a second model ===//

/// The same said differently: for each register, the set of what keeps it open.
class open_doors {
public:
    open_doors(unsigned c01, unsigned password) : c01_{c01}, password_{password} {}

    bool write(unsigned address, unsigned value)
    {
        if (address == 48) {
            if (c01_ < 10 or c01_ > 11) { return false; }
            if (value != password_ and value != 0) { return false; }
            keys_.insert("control by 48");
            if (value == password_) { keys_.insert("parameters by 48"); }
            return true;
        }
        if (address == 49) {
            if (value == password_) { keys_.insert("parameters by 49"); }
            return value == password_;
        }
        auto const has_control    = keys_.contains("control by 48");
        auto const has_parameters = keys_.contains("parameters by 48") or keys_.contains("parameters by 49");
        if (address == 1) {
            if (value == 2) {
                auto const was_open = not keys_.empty();
                keys_.clear();
                return was_open;
            }
            return has_control;
        }
        return has_parameters or (address == 40 and has_control);
    }
    void set_c01(unsigned c01)
    {
        c01_ = c01;
        if (c01 != 10 and c01 != 11) {
            keys_.erase("control by 48");
            keys_.erase("parameters by 48");
        }
    }
    void set_password(unsigned password) { password_ = password; }
    void close() { keys_.clear(); }

private:
    unsigned              c01_;
    unsigned              password_;
    std::set<std::string> keys_;
};

TEST(smd_locks, agree_with_another_model_over_random_sequences)
{
    std::mt19937 random{5};
    auto const   one_of = [&](std::initializer_list<unsigned> values) {
        return values.begin()[random() % values.size()];
    };

    std::set<lock_state> seen;
    for (int run = 0; run < 2000; ++run) {
        auto const password = one_of({0, 7, 999});
        auto const c01      = one_of({8, 10, 11, 11});
        locks      drive{control_mode{static_cast<std::uint16_t>(c01)}, static_cast<std::uint16_t>(password)};
        open_doors plain{c01, password};
        for (int step = 0; step < 40; ++step) {
            switch (random() % 12) {
            case 0: {
                auto const mode = one_of({0, 8, 9, 10, 11});
                drive.set_control_mode(control_mode{static_cast<std::uint16_t>(mode)});
                plain.set_c01(mode);
                break;
            }
            case 1: {
                auto const other = one_of({0, 7, 999});
                drive.set_password(static_cast<std::uint16_t>(other));
                plain.set_password(other);
                break;
            }
            case 2:
                drive.lock();
                plain.close();
                break;
            default: {
                auto const address = static_cast<std::uint16_t>(one_of({1, 40, 48, 48, 49, 49, 51, 61, 94, 133}));
                auto const value   = static_cast<std::uint16_t>(one_of({0, 2, 4, 6, 7, 8, 999, 0x0100}));
                auto const may     = drive.may_write(address, value);
                auto const did     = drive.write(address, value);
                ASSERT_EQ(did, may);
                ASSERT_EQ(did, plain.write(address, value)) << address << ' ' << value;
            }
            }
            seen.insert(drive.state());
        }
    }
    EXPECT_EQ(seen.size(), 4);
}

}  // namespace
