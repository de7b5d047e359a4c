#include <drivecodec/drives/smd/status_words.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::literals;
using namespace drivecodec::smd;

TEST(smd_manual, calls_a_load_byte_of_64_hexadecimal_100_percent)
{
    VERIFY(load_and_status::from_raw(0x6400).load() == 100_percent);
    VERIFY(load_and_status::from_raw(0x6406).load() == 100_percent);
}

TEST(smd_status_words, hold_two_bytes_the_high_one_first_in_the_name)
{
    VERIFY(load_and_status::from_raw(0x0006).get(load_and_status::operational_status) == operational_status::run);
    VERIFY(direction_and_mode::from_raw(0x010B).get(direction_and_mode::actual_direction) == direction::reverse);
    VERIFY(direction_and_mode::from_raw(0x010B).get(direction_and_mode::control_mode) == control_mode::c40_modbus);
    VERIFY(source_and_reference::from_raw(0x0601).get(source_and_reference::speed_source) == speed_source::serial);
    VERIFY(source_and_reference::from_raw(0x0601).get(source_and_reference::speed_reference) == speed_reference::local);
    VERIFY(fault_and_direction::from_raw(0x1801).get(fault_and_direction::fault) == fault::communication_fault);
    VERIFY(fault_and_direction::from_raw(0x1801).get(fault_and_direction::commanded_direction) == direction::reverse);
}

TEST(smd_manual, numbers_operational_states_above_7_that_a_bit_of_the_byte_could_not_be)
{
    VERIFY(load_and_status::from_raw(0x000D).get(load_and_status::operational_status) == operational_status::inhibit);
    // As bits, 0Dh would be three states at a time: fault lockout, start pending, stop.
    VERIFY(static_cast<int>(operational_status::inhibit) == 0x0D);
}

TEST(smd_status_words, change_one_byte_and_leave_the_other)
{
    constexpr auto load      = load_and_status::from_raw(0xFFFF);
    constexpr auto mode      = direction_and_mode::from_raw(0xFFFF);
    constexpr auto reference = source_and_reference::from_raw(0xFFFF);
    constexpr auto trip      = fault_and_direction::from_raw(0xFFFF);
    VERIFY(load.with(load_and_status::load_byte, 0).raw == 0x00FF);
    VERIFY(load.with(load_and_status::operational_status, operational_status::fault_lockout).raw == 0xFF00);
    VERIFY(mode.with(direction_and_mode::actual_direction, direction::forward).raw == 0x00FF);
    VERIFY(mode.with(direction_and_mode::control_mode, control_mode::analog_terminal_keypad).raw == 0xFF00);
    VERIFY(reference.with(source_and_reference::speed_source, speed_source::analog).raw == 0x00FF);
    VERIFY(reference.with(source_and_reference::speed_reference, speed_reference::serial).raw == 0xFF00);
    VERIFY(trip.with(fault_and_direction::fault, fault::no_fault).raw == 0x00FF);
    VERIFY(trip.with(fault_and_direction::commanded_direction, direction::forward).raw == 0xFF00);
}

TEST(smd_status_words, keep_every_byte)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = static_cast<std::uint16_t>(raw);
        auto const high = raw / 256;
        auto const low  = raw % 256;
        ASSERT_EQ(static_cast<unsigned>(load_and_status::from_raw(word).load().number), high);
        ASSERT_EQ(static_cast<unsigned>(load_and_status::from_raw(word).get(load_and_status::operational_status)), low);
        ASSERT_EQ(static_cast<unsigned>(direction_and_mode::from_raw(word).get(direction_and_mode::actual_direction)),
                  high);
        ASSERT_EQ(static_cast<unsigned>(direction_and_mode::from_raw(word).get(direction_and_mode::control_mode)), low);
        ASSERT_EQ(static_cast<unsigned>(source_and_reference::from_raw(word).get(source_and_reference::speed_source)),
                  high);
        ASSERT_EQ(
            static_cast<unsigned>(source_and_reference::from_raw(word).get(source_and_reference::speed_reference)),
            low);
        ASSERT_EQ(static_cast<unsigned>(fault_and_direction::from_raw(word).get(fault_and_direction::fault)), high);
        ASSERT_EQ(
            static_cast<unsigned>(fault_and_direction::from_raw(word).get(fault_and_direction::commanded_direction)),
            low);
    }
}

}  // namespace
