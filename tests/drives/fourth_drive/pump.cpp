#include "drives/fourth_drive/pump.hpp"

#include <drivecodec/modbus/rtu/adu.hpp>

#include "support/verify.hpp"

#include <string>

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;

constexpr auto fifty_hertz       = 50_Hz;
constexpr auto too_fast          = 60.1_Hz;
constexpr auto too_many_digits   = 50.05_Hz;
constexpr auto minus_three_hertz = -0.3_Hz;

// Step 1: types of its own.

TEST(fourth_drive, has_words_and_codes_of_which_the_unknown_survive)
{
    VERIFY(pump::status.value(0x0009).test(pump::status_word::dry));
    VERIFY(pump::operating_mode.value(2) == pump::mode::by_level);
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        ASSERT_EQ(pump::status.value(static_cast<std::uint16_t>(raw)).raw, raw);
        ASSERT_EQ(static_cast<unsigned>(pump::operating_mode.value(static_cast<std::uint16_t>(raw))), raw);
    }
}

// Step 2: the table.

TEST(fourth_drive, has_a_table_that_says_what_may_be_written)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = static_cast<std::uint16_t>(raw);
        ASSERT_EQ(pump::find(200)->check_write(word).ok(), raw <= 600) << raw;
        ASSERT_EQ(pump::find(201)->check_write(word).ok(), raw <= 2) << raw;
        ASSERT_EQ(pump::find(100)->check_write(word), (error{errc::read_only, 0})) << raw;
        ASSERT_TRUE(pump::find(202)->check_write(word).ok()) << raw;  // nobody says that it may not
        ASSERT_EQ(pump::find(203)->check_write(word), (error{errc::read_only, 0})) << raw;
    }
    VERIFY(check_range(pump::table, 200, 4).ok() and check_range(pump::table, 101, 2) == error{errc::bad_address, 1});
    for (auto const& row : pump::table) {
        EXPECT_TRUE(row.factory_setting.from == drives::source::nobody or row.check(row.factory_setting.number).ok());
    }
}

// Step 3: functions, and registers by name.

TEST(fourth_drive, serves_its_functions_and_no_others)
{
    for (unsigned code = 1; code < 0x80; ++code) {
        std::array<std::uint8_t, 1> const pdu{static_cast<std::uint8_t>(code)};
        auto const                        is_served = pump::functions::find(pdu, [](auto) {});
        EXPECT_EQ(is_served, code == 3 or code == 6 or code == 16) << code;
    }
}

TEST(fourth_drive, is_spoken_to_in_frames_that_the_compiler_builds)
{
    constexpr auto frame = modbus::rtu::encode(3, pump::speed_reference.write(50.0_Hz));
    VERIFY(frame == std::array<std::uint8_t, 8>{0x03, 0x06, 0x00, 0xC8, 0x01, 0xF4, 0x09, 0xC1});

    VERIFY(pump::actual_speed.value(0xFFFD) == minus_three_hertz);
    VERIFY(pump::speed_reference.make_write(fifty_hertz)->value == 500);
    VERIFY(pump::speed_reference.make_write(too_fast).error() == error{errc::out_of_range, 0});
    VERIFY(pump::speed_reference.make_write(too_many_digits).error() == error{errc::inexact, 0});
    VERIFY(pump::operating_mode.make_write(pump::mode{3}).error() == error{errc::out_of_range, 0});
    VERIFY(pump::status.make_write({}).error() == error{errc::read_only, 0});
}

TEST(fourth_drive, reads_and_writes_neighbours_at_once)
{
    using both             = pump::registers<pump::speed_reference, pump::operating_mode>;
    constexpr auto asked   = both::read();
    constexpr auto written = both::write(50_Hz, pump::mode::by_hand);
    VERIFY(asked.range.first() == 200 and asked.range.count() == 2);
    VERIFY(written.block.values().words == std::array<std::uint16_t, 2>{500, 1});
}

// Step 4: lookups.

TEST(fourth_drive, is_found_by_address_code_menu_and_name)
{
    for (auto const& row : pump::table) { EXPECT_EQ(pump::find(row.address), &row); }
    VERIFY(pump::find("REF") == &pump::table[2] and pump::find("2.0") == &pump::table[2]);
    VERIFY(pump::find("speed_reference") == &pump::table[2] and pump::find("2.3") == &pump::table[5]);
    VERIFY(pump::find("reserve") == nullptr and pump::find("") == nullptr);  // two have the name
    VERIFY(pump::find(99) == nullptr and pump::find(102) == nullptr);
}

// Step 5: words.

std::string text_of(std::uint16_t address, std::uint16_t raw)
{
    std::array<char, 60> room{};
    text_writer          out{room};
    pump::write_text(out, address, raw);
    return std::string{out.view()};
}

TEST(fourth_drive, says_what_it_has)
{
    EXPECT_EQ(text_of(100, 0x0009), "STA running dry");
    EXPECT_EQ(text_of(101, 0xFFFD), "actual_speed -0.3 Hz");
    EXPECT_EQ(text_of(200, 500), "speed_reference 50.0 Hz");
    EXPECT_EQ(text_of(201, 2), "mode by_level");
    EXPECT_EQ(text_of(201, 7), "mode 7");
    EXPECT_EQ(text_of(999, 0x0012), "register 999: 0012");
}

}  // namespace
