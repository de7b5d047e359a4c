#include <drivecodec/text/drives/vlt6000/parameters.hpp>

#include <drivecodec/text/core.hpp>

#include "support/verify.hpp"

#include <array>
#include <string>

namespace {

using drivecodec::vlt6000::parameter_value;

constexpr bool reads(std::uint16_t number, std::uint32_t pwe, std::string_view expected)
{
    std::array<char, 1200> room{};
    return drivecodec::describe(parameter_value{number, pwe}, room) == expected;
}

TEST(text_vlt6000_parameters, examples_of_the_manual)
{
    VERIFY(reads(202, 0x03E8, "202 output_frequency_high_limit 100.0 Hz"));
    VERIFY(reads(206, 0x000A, "206 ramp_up_time 10 s"));
    VERIFY(reads(415, 0x0014, "415 process_units kilowatt"));
}

TEST(text_vlt6000_parameters, choices_by_name_and_others_by_number)
{
    VERIFY(reads(500, 0, "500 protocol fc_protocol"));
    VERIFY(reads(502, 5, "502 baudrate baud_9600"));
    VERIFY(reads(505, 3, "505 start logic_or"));
    VERIFY(reads(556, 5, "556 bus_time_interval_function stop_and_trip"));
    VERIFY(reads(505, 4, "505 start 4"));
    VERIFY(reads(505, 0x10003, "505 start 65539"));
    VERIFY(reads(415, 7, "415 process_units 7"));
}

TEST(text_vlt6000_parameters, words_in_words)
{
    VERIFY(reads(529, 0x402, "529 alarm_word 00000402 trip_locked earth_fault"));
    VERIFY(reads(521, 0x28, "521 digital_input 00101000 18 27"));
    VERIFY(reads(530, 0x043C, "530 control_word CTW 043C ramp_stop preset_reference_1 setup_1"));
    VERIFY(reads(527, 0x1'0F03, "527 status_word 00010F03"));  // no status word has 32 bits
}

TEST(text_vlt6000_parameters, without_a_scale_what_was_transferred)
{
    VERIFY(reads(207, 100, "207 ramp_down_time 100"));
    VERIFY(reads(103, 400, "103 400"));
    VERIFY(reads(300, 0xFFFFFFFF, "300 4294967295"));
}

TEST(text_vlt6000_parameters, every_number_has_a_text)
{
    for (std::uint16_t number = 0; number < 2048; ++number) {
        std::array<char, 1200> room{};
        auto const             text = drivecodec::describe(parameter_value{number, 1}, room);
        EXPECT_TRUE(text.starts_with(std::to_string(number) + ' ')) << text;
    }
}

}  // namespace
