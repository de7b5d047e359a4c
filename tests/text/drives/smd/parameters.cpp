#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/smd/parameters.hpp>

#include "support/verify.hpp"

#include <array>
#include <string>

namespace {

using namespace drivecodec;
using drivecodec::describe;

std::string text_of(smd::version version, unsigned address, unsigned raw)
{
    std::array<char, 200> room{};
    return std::string{describe(
        smd::register_value{version, static_cast<std::uint16_t>(address), static_cast<std::uint16_t>(raw)}, room)};
}

TEST(text_smd_parameters, are_numbers_with_their_unit)
{
    EXPECT_EQ(text_of(smd::pv507, 61, 50), "C12 acceleration_time 5.0 s");
    EXPECT_EQ(text_of(smd::pv400, 60, 500), "C11 maximum_output_frequency 50.0 Hz");
    EXPECT_EQ(text_of(smd::pv400, 69, 150), "C22 current_limit 150 %");
    EXPECT_EQ(text_of(smd::pv507, 120, 1000), "c87 pi_max_feedback 100.0");
    EXPECT_EQ(text_of(smd::pv507, 133, 50), "n23 serial_fault_time 0.050 s");
}

TEST(text_smd_parameters, are_choices_by_name)
{
    EXPECT_EQ(text_of(smd::pv507, 51, 11), "C01 setpoint_and_control_source c40_modbus");
    EXPECT_EQ(text_of(smd::pv507, 63, 2), "C14 operating_mode linear_with_constant_boost");
    EXPECT_EQ(text_of(smd::pv507, 63, 4), "C14 operating_mode 4");
    EXPECT_EQ(text_of(smd::pv400, 53, 15), "CE1 configuration_digital_input_e1 activate_fixed_pi_setpoint_2");
    EXPECT_EQ(text_of(smd::pv400, 114, 3), "n22 serial_timeout_action trip_fault_fc3");
}

TEST(text_smd_parameters, are_those_of_their_version)
{
    EXPECT_EQ(text_of(smd::pv400, 71, 1), "C34 configuration_analog_input input_0_to_5_v");
    EXPECT_EQ(text_of(smd::pv507, 71, 1), "C31 analog_input_deadband deadband_disabled");
    EXPECT_EQ(text_of(smd::pv507, 56, 0x1388), "register 56: 1388");
}

TEST(text_smd_parameters, are_control_registers_by_name)
{
    EXPECT_EQ(text_of(smd::pv507, 1, 0x0008), "drive_control 0008 start");
    EXPECT_EQ(text_of(smd::pv507, 19, 69), "drive_family smd");
    EXPECT_EQ(text_of(smd::pv507, 19, 67), "drive_family 67");
    EXPECT_EQ(text_of(smd::pv507, 40, 412), "serial_speed_command 41.2 Hz");
    EXPECT_EQ(text_of(smd::pv507, 26, 0x6406), "load_and_operational_status 100 %, run");
    EXPECT_EQ(text_of(smd::pv400, 50, 400), "register_version 400");
}

TEST(text_smd_parameters, are_a_software_version_in_quotes)
{
    constexpr std::array<std::uint16_t, 4> words{0x534D, 0x4420, 0x312E, 0x3531};
    std::array<char, 50>                   room{};
    EXPECT_EQ(describe(*smd::software_version::make(words), room), "\"SMD 1.51\"");
}

TEST(text_smd_parameters, of_any_register_and_value_are_written)
{
    for (auto const version : {smd::pv400, smd::pv507}) {
        for (unsigned address = 0; address < 140; ++address) {
            for (unsigned raw = 0; raw <= 0xFFFF; raw += 7) {
                auto const text = text_of(version, address, raw);
                ASSERT_GT(text.size(), 10U);
                ASSERT_LT(text.size(), 120U);
            }
        }
    }
}

}  // namespace
