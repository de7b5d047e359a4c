#include <drivecodec/drives/smd/registers.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;

// Section 7.3 of the manual: the basic drive commands.
TEST(smd_manual, gives_commands_to_register_1)
{
    VERIFY(encode(smd::drive_control.write(smd::command::stop)) == "06 00 01 00 04"_hex);
    VERIFY(encode(smd::drive_control.write(smd::command::start)) == "06 00 01 00 08"_hex);
    VERIFY(encode(smd::drive_control.write(smd::command::set_reverse)) == "06 00 01 00 40"_hex);
    VERIFY(encode(smd::drive_control.write(smd::command::set_forward)) == "06 00 01 00 80"_hex);
    VERIFY(encode(smd::drive_control.write(smd::command::serial_speed_reference)) == "06 00 01 01 00"_hex);
    VERIFY(encode(smd::drive_control.write(smd::command::lock)) == "06 00 01 00 02"_hex);
}

TEST(smd_manual, writes_412_for_41_2_hertz)
{
    VERIFY(encode(smd::serial_speed_command.write(41.2_Hz)) == "06 00 28 01 9C"_hex);
    VERIFY(smd::serial_speed_command.make_write(41.25_Hz).error() == error{errc::inexact, 0});
    VERIFY(smd::serial_speed_command.make_write(240.1_Hz).error() == error{errc::out_of_range, 0});
    VERIFY(smd::serial_speed_command.make_write(-0.1_Hz).error() == error{errc::out_of_range, 0});
}

// Table 6 ends every frame with CRCH CRCL and shows no number. Of these frames the checksums are CF45h and CCD9h.
TEST(smd_manual, writes_the_checksum_high_byte_first_which_modbus_sends_low_byte_first)
{
    VERIFY(modbus::rtu::encode(1, smd::drive_status.read()) == "01 03 00 18 00 06 45 CF"_hex);
    VERIFY(modbus::rtu::encode(1, smd::drive_control.write(smd::command::start)) == "01 06 00 01 00 08 D9 CC"_hex);
}

TEST(smd_manual, reads_0201_in_hexadecimal_as_51_3_hertz)
{
    VERIFY(smd::command_speed.value(0x0201) == 51.3_Hz);
}

TEST(smd_registers, limit_a_speed_to_what_C10_and_C11_are_set_to)
{
    VERIFY(smd::make_serial_speed(41.2_Hz, 0_Hz, 50_Hz)->value == 412);
    VERIFY(smd::make_serial_speed(50_Hz, 0_Hz, 50_Hz)->value == 500);
    VERIFY(smd::make_serial_speed(5_Hz, 5_Hz, 50_Hz)->value == 50);
    VERIFY(smd::make_serial_speed(50.1_Hz, 0_Hz, 50_Hz).error() == error{errc::out_of_range, 0});
    VERIFY(smd::make_serial_speed(4.9_Hz, 5_Hz, 50_Hz).error() == error{errc::out_of_range, 0});
    VERIFY(smd::make_serial_speed(41.25_Hz, 0_Hz, 50_Hz).error() == error{errc::inexact, 0});
}

TEST(smd_registers, take_a_password_up_to_999)
{
    for (int password = -1; password <= 1001; ++password) {
        auto const may = password >= 0 and password <= 999;
        EXPECT_EQ(smd::unlock_commands.make_write(password).has_value(), may);
        EXPECT_EQ(smd::unlock_parameters.make_write(password).has_value(), may);
    }
    VERIFY(encode(smd::unlock_commands.write(0)) == "06 00 30 00 00"_hex);
    VERIFY(encode(smd::unlock_parameters.write(999)) == "06 00 31 03 E7"_hex);
}

TEST(smd_registers, read_the_drive_status_at_once)
{
    VERIFY(encode(smd::drive_status.read()) == "03 00 18 00 06"_hex);
    constexpr std::array<std::uint16_t, 6> words{412, 400, 0x3206, 0x000B, 0x0600, 0x0000};
    VERIFY(smd::drive_status.value(words)->command_speed == 41.2_Hz);
    VERIFY(smd::drive_status.value(words)->load == 50_percent);
    VERIFY(not smd::drive_status.value(std::array<std::uint16_t, 5>{}));
}

TEST(smd_registers, are_of_their_types)
{
    VERIFY(smd::drive_family.value(0x0045) == smd::family::smd and smd::drive_family.value(67) == smd::family{67});
    VERIFY(smd::drive_size.value(0) == 0);
    VERIFY(smd::drive_hardware.value(0x0004).test(smd::hardware::oem_defaults_present));
    VERIFY(smd::actual_speed.value(2400) == 240_Hz);
    VERIFY(smd::load_and_operational_status.value(0x6406).load() == 100_percent);
    VERIFY(smd::motor_volts.value(100) == 100_percent);
    VERIFY(*smd::make_version(smd::register_version.value(507)) == smd::pv507);
    VERIFY(smd::register_version.make_write(507).error() == error{errc::read_only, 0});
    VERIFY(smd::drive_control.make_write(smd::command{0x0088}).error() == error{errc::out_of_range, 0});
}

TEST(smd_registers, are_read_one_at_a_time)
{
    VERIFY(encode(smd::load_and_operational_status.read()) == "03 00 1A 00 01"_hex);
    VERIFY(encode(smd::register_version.read()) == "03 00 32 00 01"_hex);
}

}  // namespace
