#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/xd1000/registers.hpp>

#include "support/verify.hpp"

#include <array>
#include <string>
#include <vector>

namespace {

using namespace drivecodec::xd1000;
using drivecodec::describe;

std::string text_of(unsigned address, unsigned raw)
{
    std::array<char, 200> room{};
    return std::string{
        describe(register_value{static_cast<std::uint16_t>(address), static_cast<std::uint16_t>(raw)}, room)};
}

TEST(text_xd1000_registers, are_numbers_with_their_unit)
{
    EXPECT_EQ(text_of(3102, 0x0028), "switching_frequency 4.0 kHz");
    EXPECT_EQ(text_of(3103, 0x0258), "maximum_output_frequency 60.0 Hz");
    EXPECT_EQ(text_of(3104, 0x01F4), "high_speed 50.0 Hz");
    EXPECT_EQ(text_of(3105, 0), "low_speed 0.0 Hz");
    EXPECT_EQ(text_of(6005, 100), "time_out 10.0 s");
    EXPECT_EQ(text_of(8602, 0xFA24), "speed_reference -1500 rpm");
    EXPECT_EQ(text_of(8604, 1500), "speed_feedback 1500 rpm");
    EXPECT_EQ(text_of(9001, 0x000D), "acceleration 13 s");
}

TEST(text_xd1000_registers, are_words_and_codes_by_name)
{
    EXPECT_EQ(text_of(8501, 0x000F), "CMD 000F enable_operation");
    EXPECT_EQ(text_of(3201, 0x0637), "ETA 0637 operation_enabled remote reference_reached");
    EXPECT_EQ(text_of(3206, 0x1234), "ETI 1234");
    EXPECT_EQ(text_of(8504, 0x1234), "CMI 1234");
    EXPECT_EQ(text_of(6001, 0), "modbus_address off");
    EXPECT_EQ(text_of(6001, 247), "modbus_address 247");
    EXPECT_EQ(text_of(6003, 32), "baud_rate baud_19200");
    EXPECT_EQ(text_of(6003, 33), "baud_rate 33");
    EXPECT_EQ(text_of(6004, 3), "character_format format_8e1");
}

TEST(text_xd1000_registers, of_the_scanner_name_what_they_are_of)
{
    EXPECT_EQ(text_of(12701, 3201), "input_1_source 3201 ETA");
    EXPECT_EQ(text_of(12702, 8604), "input_2_source 8604 speed_feedback");
    EXPECT_EQ(text_of(12703, 0), "input_3_source 0 unused");
    EXPECT_EQ(text_of(12724, 5000), "output_4_destination 5000");
    EXPECT_EQ(text_of(12741, 0x0637), "NM1 0637");
    EXPECT_EQ(text_of(12764, 0x0006), "NC4 0006");
}

TEST(text_xd1000_registers, that_the_manual_does_not_have_are_numbers)
{
    EXPECT_EQ(text_of(5000, 0x1388), "register 5000: 1388");
    EXPECT_EQ(text_of(0, 0), "register 0: 0000");
}

TEST(text_xd1000_registers, name_a_command_by_the_present_state)
{
    std::array<char, 100>   room{};
    drivecodec::text_writer out{room};
    write_text(out, register_value{8501, 0x0007}, drivecodec::cia402::state::operation_enabled);
    EXPECT_EQ(out.view(), "CMD 0007 disable_operation");
}

TEST(text_xd1000_manual, reads_four_words_from_3102_on)
{
    constexpr std::array<std::uint16_t, 4> values{0x0028, 0x0258, 0x01F4, 0x0000};
    std::array<char, 200>                  room{};
    EXPECT_EQ(describe(register_values{3102, values}, room), "switching_frequency 4.0 kHz, maximum_output_frequency "
                                                             "60.0 Hz, high_speed 50.0 Hz, low_speed 0.0 Hz");
    EXPECT_EQ(describe(register_values{3102, {}}, room), "");
}

/// A block that passes address 65535 is a server's mistake, and no reason to fail.
TEST(text_xd1000_registers, of_any_address_and_value_are_written)
{
    constexpr std::array<std::uint16_t, 2> values{1, 2};
    std::array<char, 200>                  room{};
    EXPECT_EQ(describe(register_values{0xFFFF, values}, room), "register 65535: 0001, register 0: 0002");
    for (auto const& row : table) {
        for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
            auto const text = describe(register_value{row.address, static_cast<std::uint16_t>(raw)}, room);
            ASSERT_GT(text.size(), drivecodec::drives::title(row).size() + 1);
            ASSERT_LT(text.size(), 140U);
        }
    }
}

}  // namespace
