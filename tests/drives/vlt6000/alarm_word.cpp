#include <drivecodec/drives/vlt6000/alarm_word.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::vlt6000;

using alarm = alarm_word;

// VLT 6000 manual, "Warning words 1+2 and Alarm word", table "Alarm word": each code with the manual's words.
// clang-format off
static_assert(alarm::of(alarm::unknown_fault).raw == 0x0000'0001);  // Unknown fault
static_assert(alarm::of(alarm::trip_locked).raw == 0x0000'0002);  // Trip locked
static_assert(alarm::of(alarm::auto_optimisation_not_ok).raw == 0x0000'0004);  // Auto-optimisation not OK
static_assert(alarm::of(alarm::hpfb_bus_timeout).raw == 0x0000'0008);  // HPFB bus timeout
static_assert(alarm::of(alarm::serial_communication_timeout).raw == 0x0000'0010);  // Serial communication timeout
static_assert(alarm::of(alarm::asic_fault).raw == 0x0000'0020);  // ASIC fault
static_assert(alarm::of(alarm::hpfp_bus_timeout).raw == 0x0000'0040);  // HPFP bus timeout
static_assert(alarm::of(alarm::standard_bus_timeout).raw == 0x0000'0080);  // Standard bus timeout
static_assert(alarm::of(alarm::short_circuiting).raw == 0x0000'0100);  // Short-circuiting
static_assert(alarm::of(alarm::switchmode_fault).raw == 0x0000'0200);  // Switchmode fault
static_assert(alarm::of(alarm::earth_fault).raw == 0x0000'0400);  // Earth fault
static_assert(alarm::of(alarm::current_limit).raw == 0x0000'0800);  // Current limit
static_assert(alarm::of(alarm::overcurrent).raw == 0x0000'1000);  // Overcurrent
static_assert(alarm::of(alarm::motor_thermistor).raw == 0x0000'2000);  // Motor thermistor
static_assert(alarm::of(alarm::motor_overheated).raw == 0x0000'4000);  // Motor overheated
static_assert(alarm::of(alarm::inverter_overheated).raw == 0x0000'8000);  // Inverter overheated
static_assert(alarm::of(alarm::undervoltage).raw == 0x0001'0000);  // Undervoltage
static_assert(alarm::of(alarm::overvoltage).raw == 0x0002'0000);  // Overvoltage
static_assert(alarm::of(alarm::mains_phase_fault).raw == 0x0004'0000);  // Mains phase fault
static_assert(alarm::of(alarm::live_zero_fault).raw == 0x0008'0000);  // Live zero fault
static_assert(alarm::of(alarm::heat_sink_temperature_too_high).raw == 0x0010'0000);  // Heat sink temperature too high
static_assert(alarm::of(alarm::motor_phase_w_missing).raw == 0x0020'0000);  // Motor phase W missing
static_assert(alarm::of(alarm::motor_phase_v_missing).raw == 0x0040'0000);  // Motor phase V missing
static_assert(alarm::of(alarm::motor_phase_u_missing).raw == 0x0080'0000);  // Motor phase U missing
static_assert(alarm::of(alarm::profibus_communication_fault).raw == 0x0100'0000);  // Profibus communication fault
static_assert(alarm::of(alarm::inverter_fault).raw == 0x0200'0000);  // Inverter fault
static_assert(alarm::of(alarm::output_current_low).raw == 0x0400'0000);  // Output current low
static_assert(alarm::of(alarm::safety_stop).raw == 0x0800'0000);  // Safety stop
static_assert(alarm::of(alarm::reserved_28).raw == 0x1000'0000);  // Reserved
// clang-format on

TEST(vlt6000_manual, ends_the_alarm_word_at_bit_28_but_the_last_three_survive)
{
    VERIFY(alarm_word::from_raw(0xE000'0000).raw == 0xE000'0000);
    VERIFY(alarm_word::from_raw(0xE000'0010).without(alarm_word::serial_communication_timeout).raw == 0xE000'0000);
}

TEST(vlt6000_manual, has_two_spellings_hpfb_and_hpfp_at_two_bits_of_the_alarm_word)
{
    VERIFY(alarm_word::from_raw(0x0000'0008).test(alarm_word::hpfb_bus_timeout));
    VERIFY(not alarm_word::from_raw(0x0000'0008).test(alarm_word::hpfp_bus_timeout));
    VERIFY(alarm_word::from_raw(0x0000'0040).test(alarm_word::hpfp_bus_timeout));
    VERIFY(not alarm_word::from_raw(0x0000'0040).test(alarm_word::hpfb_bus_timeout));
}

TEST(vlt6000_manual, has_four_timeouts_of_buses_in_the_alarm_word)
{
    VERIFY(alarm_word::of(alarm_word::hpfb_bus_timeout, alarm_word::serial_communication_timeout,
                          alarm_word::hpfp_bus_timeout, alarm_word::standard_bus_timeout)
               .raw
           == 0x0000'00D8);
}

TEST(vlt6000_manual, calls_several_alarms_a_sum_where_it_is_a_bitwise_or)
{
    VERIFY(alarm_word::of(alarm_word::earth_fault, alarm_word::trip_locked).raw == 0x0000'0402);
    VERIFY(alarm_word::of(alarm_word::earth_fault, alarm_word::earth_fault).raw == 0x0000'0400);
}

TEST(vlt6000_alarm_word, keeps_every_bit_that_it_is_given)
{
    for (unsigned bit = 0; bit < 32; ++bit) {
        auto const alone  = std::uint32_t{1} << bit;
        auto const others = ~alone;
        EXPECT_EQ(alarm_word::from_raw(alone).raw, alone);
        EXPECT_EQ(alarm_word::from_raw(others).raw, others);
        EXPECT_EQ(alarm_word::from_raw(alone).test(alarm_word::safety_stop), alone == 0x0800'0000U);
        EXPECT_EQ(alarm_word::from_raw(others).with(alarm_word::safety_stop).raw, others | 0x0800'0000U);
        EXPECT_EQ(alarm_word::from_raw(others).without(alarm_word::safety_stop).raw, others & ~0x0800'0000U);
    }
    VERIFY(alarm_word::from_raw(0xFFFF'FFFFU).raw == 0xFFFF'FFFFU);
}

}  // namespace
