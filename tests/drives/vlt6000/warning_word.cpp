#include <drivecodec/drives/vlt6000/warning_word.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::vlt6000;

using warning = warning_word;

// VLT 6000 manual, "Warning words 1+2 and Alarm word", table "Warning word": each code with the manual's words.
// clang-format off
static_assert(warning::of(warning::reference_high).raw == 0x0000'0001);  // Reference high
static_assert(warning::of(warning::fault_in_eeprom_on_control_card).raw == 0x0000'0002);
static_assert(warning::of(warning::fault_in_eeprom_on_power_card).raw == 0x0000'0004);  // Fault in EEprom on power card
static_assert(warning::of(warning::hpfb_bus_timeout).raw == 0x0000'0008);  // HPFB bus timeout
static_assert(warning::of(warning::serial_communication_timeout).raw == 0x0000'0010);  // Serial communication timeout
static_assert(warning::of(warning::overcurrent).raw == 0x0000'0020);  // Overcurrent
static_assert(warning::of(warning::current_limit).raw == 0x0000'0040);  // Current limit
static_assert(warning::of(warning::motor_thermistor).raw == 0x0000'0080);  // Motor thermistor
static_assert(warning::of(warning::motor_overtemperature).raw == 0x0000'0100);  // Motor overtemperature
static_assert(warning::of(warning::inverter_overtemperature).raw == 0x0000'0200);  // Inverter overtemperature
static_assert(warning::of(warning::undervoltage).raw == 0x0000'0400);  // Undervoltage
static_assert(warning::of(warning::overvoltage).raw == 0x0000'0800);  // Overvoltage
static_assert(warning::of(warning::voltage_warning_low).raw == 0x0000'1000);  // Voltage warning low
static_assert(warning::of(warning::voltage_warning_high).raw == 0x0000'2000);  // Voltage warning high
static_assert(warning::of(warning::mains_phase_fault).raw == 0x0000'4000);  // Mains phase fault
static_assert(warning::of(warning::live_zero_fault).raw == 0x0000'8000);  // Live zero fault
static_assert(warning::of(warning::under_10_volt).raw == 0x0001'0000);  // Under 10 Volt (terminal 50)
static_assert(warning::of(warning::reference_low).raw == 0x0002'0000);  // Reference low
static_assert(warning::of(warning::feedback_high).raw == 0x0004'0000);  // Feedback high
static_assert(warning::of(warning::feedback_low).raw == 0x0008'0000);  // Feedback low
static_assert(warning::of(warning::output_current_high).raw == 0x0010'0000);  // Output current high
static_assert(warning::of(warning::out_of_frequency_range).raw == 0x0020'0000);  // Out of frequency range
static_assert(warning::of(warning::profibus_communication_fault).raw == 0x0040'0000);  // Profibus communication fault
static_assert(warning::of(warning::output_current_low).raw == 0x0080'0000);  // Output current low
static_assert(warning::of(warning::output_frequency_high).raw == 0x0100'0000);  // Output frequency high
static_assert(warning::of(warning::output_frequency_low).raw == 0x0200'0000);  // Output frequency low
static_assert(warning::of(warning::ama_motor_too_small).raw == 0x0400'0000);  // AMA - motor too small
static_assert(warning::of(warning::ama_motor_too_big).raw == 0x0800'0000);  // AMA - motor too big
static_assert(warning::of(warning::ama_check_parameters_102_103_105).raw == 0x1000'0000);
static_assert(warning::of(warning::ama_check_parameters_102_104_106).raw == 0x2000'0000);
static_assert(warning::of(warning::reserved_30).raw == 0x4000'0000);  // Reserved
static_assert(warning::of(warning::reserved_31).raw == 0x8000'0000);  // Reserved
// clang-format on

TEST(vlt6000_manual, promises_two_warning_words_but_has_one_of_32_bits)
{
    VERIFY(sizeof(warning_word) == 4);
    VERIFY(warning_word::of(warning_word::reference_high, warning_word::reserved_31).raw == 0x8000'0001);
}

TEST(vlt6000_manual, calls_several_warnings_a_sum_where_it_is_a_bitwise_or)
{
    VERIFY(warning_word::of(warning_word::overcurrent, warning_word::current_limit).raw == 0x0000'0060);
    VERIFY(warning_word::of(warning_word::overcurrent, warning_word::overcurrent).raw == 0x0000'0020);
}

TEST(vlt6000_warning_word, keeps_every_bit_that_it_is_given)
{
    for (unsigned bit = 0; bit < 32; ++bit) {
        auto const alone  = std::uint32_t{1} << bit;
        auto const others = ~alone;
        EXPECT_EQ(warning_word::from_raw(alone).raw, alone);
        EXPECT_EQ(warning_word::from_raw(others).raw, others);
        EXPECT_EQ(warning_word::from_raw(alone).test(warning_word::live_zero_fault), alone == 0x0000'8000U);
        EXPECT_EQ(warning_word::from_raw(others).with(warning_word::live_zero_fault).raw, others | 0x0000'8000U);
        EXPECT_EQ(warning_word::from_raw(others).without(warning_word::live_zero_fault).raw, others & ~0x0000'8000U);
    }
    VERIFY(warning_word::from_raw(0xFFFF'FFFFU).raw == 0xFFFF'FFFFU);
}

}  // namespace
