#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/vlt6000/words.hpp>

#include "support/verify.hpp"

#include <array>
#include <cstdio>
#include <set>
#include <string>

namespace {

using namespace drivecodec::vlt6000;
using drivecodec::describe;

template <typename Word>
std::string text_of(unsigned raw)
{
    std::array<char, 1000> room{};
    return std::string{describe(Word::from_raw(static_cast<typename Word::raw_type>(raw)), room)};
}
std::string ctw_text(unsigned raw)
{
    return text_of<control_word>(raw);
}
std::string stw_text(unsigned raw)
{
    return text_of<status_word>(raw);
}

template <std::size_t N>
std::string hex(unsigned raw)
{
    std::array<char, N + 1> digits{};
    std::snprintf(digits.data(), digits.size(), "%0*X", static_cast<int>(N), raw);
    return digits.data();
}

//=== control word ===//

TEST(text_vlt6000_words, name_the_start_command_of_the_manual)
{
    EXPECT_EQ(ctw_text(0x047F), "CTW 047F start preset_reference_4 setup_1");
}

TEST(text_vlt6000_words, name_what_a_control_word_commands_at_0)
{
    EXPECT_EQ(ctw_text(0x043F), "CTW 043F ramp_stop preset_reference_4 setup_1");
    EXPECT_EQ(ctw_text(0x047B), "CTW 047B start dc_brake preset_reference_4 setup_1");
    EXPECT_EQ(ctw_text(0x0477), "CTW 0477 start coasting_stop preset_reference_4 setup_1");
    EXPECT_EQ(ctw_text(0x046F), "CTW 046F start quick_stop preset_reference_4 setup_1");
    EXPECT_EQ(ctw_text(0x045F), "CTW 045F start freeze_output preset_reference_4 setup_1");
    EXPECT_EQ(ctw_text(0x0417), "CTW 0417 ramp_stop coasting_stop freeze_output preset_reference_4 setup_1");
}

TEST(text_vlt6000_words, say_that_a_control_word_is_ignored)
{
    EXPECT_EQ(ctw_text(0x007F), "CTW 007F data_not_valid start preset_reference_4 setup_1");
    EXPECT_EQ(ctw_text(0x0000), "CTW 0000 data_not_valid ramp_stop dc_brake coasting_stop quick_stop freeze_output "
                                "preset_reference_1 setup_1");
}

TEST(text_vlt6000_words, name_what_a_control_word_commands_at_1)
{
    EXPECT_EQ(ctw_text(0x04FC), "CTW 04FC start preset_reference_1 setup_1 reset");
    EXPECT_EQ(ctw_text(0x257D), "CTW 257D start preset_reference_2 setup_2 jog");
    EXPECT_EQ(ctw_text(0xDC7E), "CTW DC7E start preset_reference_3 setup_3 relay_1 relay_2 reversing");
    EXPECT_EQ(ctw_text(0x663C), "CTW 663C ramp_stop preset_reference_1 setup_4 +0200");
}

//=== status word ===//

TEST(text_vlt6000_words, name_the_status_of_the_manual_s_example)
{
    EXPECT_EQ(stw_text(0x0F03), "STW 0F03 serial_control control_ready drive_ready speed_equals_reference "
                                "within_frequency_range running");
}

TEST(text_vlt6000_words, name_every_bit_of_a_status)
{
    EXPECT_EQ(stw_text(0x0000), "STW 0000 local_operation");
    EXPECT_EQ(stw_text(0x0001), "STW 0001 local_operation control_ready");
    EXPECT_EQ(stw_text(0x0002), "STW 0002 local_operation drive_ready");
    EXPECT_EQ(stw_text(0x0004), "STW 0004 local_operation stand_by");
    EXPECT_EQ(stw_text(0x0008), "STW 0008 local_operation tripped");
    EXPECT_EQ(stw_text(0x0080), "STW 0080 local_operation warning");
    EXPECT_EQ(stw_text(0x0100), "STW 0100 local_operation speed_equals_reference");
    EXPECT_EQ(stw_text(0x0200), "STW 0200 serial_control");
    EXPECT_EQ(stw_text(0x0400), "STW 0400 local_operation within_frequency_range");
    EXPECT_EQ(stw_text(0x0800), "STW 0800 local_operation running");
    EXPECT_EQ(stw_text(0x2000), "STW 2000 local_operation voltage_warning");
    EXPECT_EQ(stw_text(0x4000), "STW 4000 local_operation current_limit");
    EXPECT_EQ(stw_text(0x8000), "STW 8000 local_operation thermal_warning");
    EXPECT_EQ(stw_text(0x1070), "STW 1070 local_operation +1070");
}

/// So that nothing is lost that has no name, and nothing is told twice alike.
TEST(text_vlt6000_words, begin_with_their_number_and_differ_in_what_follows)
{
    std::set<std::string> commands;
    std::set<std::string> states;
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const ctw = ctw_text(raw);
        auto const stw = stw_text(raw);
        ASSERT_EQ(ctw.substr(0, 9), "CTW " + hex<4>(raw) + " ");
        ASSERT_EQ(stw.substr(0, 9), "STW " + hex<4>(raw) + " ");
        ASSERT_TRUE(commands.insert(ctw.substr(9)).second) << ctw;
        ASSERT_TRUE(states.insert(stw.substr(9)).second) << stw;
    }
}

//=== words of 32 bits: the manual's tables, in the library's words ===//

// clang-format off
constexpr std::array<std::string_view, 32> states{{
    "overvoltage_control_active",  // 00000001 Overvoltage control active
    "start_delay",  // 00000002 Start delay
    "sleep_boost_active",  // 00000004 Sleep boost active
    "sleep_mode_active",  // 00000008 Sleep mode active
    "automatic_motor_adaptation_completed",  // 00000010 Automatic motor adaptation completed
    "automatic_motor_adaptation_running",  // 00000020 Automatic motor adaptation running
    "reversing_and_start",  // 00000040 Reversing and start
    "ramp_operation",  // 00000080 Ramp operation
    "reversing",  // 00000100 Reversing
    "speed_equals_reference",  // 00000200 Speed = reference
    "running",  // 00000400 Running
    "remote_controlled_reference",  // 00000800 Local ref. = 0, Remote controlled ref. = 1
    "off_mode",  // 00001000 OFF mode = 1
    "hand_mode",  // 00002000 Auto mode = 0, Hand mode = 1
    "start_blocked",  // 00004000 Start blocked
    "start_blocked_signal_missing",  // 00008000 Start blocked signal missing
    "freeze_output",  // 00010000 Freeze output
    "freeze_output_blocked",  // 00020000 Freeze output blocked
    "jogging",  // 00040000 Jogging
    "jog_blocked",  // 00080000 Jog blocked
    "stand_by",  // 00100000 Stand by
    "stop",  // 00200000 Stop
    "dc_stop",  // 00400000 DC stop
    "drive_ready_23",  // 00800000 Drive ready
    "relay_123_active",  // 01000000 Relay 123 active
    "drive_ready_25",  // 02000000 Drive ready
    "control_ready",  // 04000000 Control ready
    "start_prevented",  // 08000000 Start prevented
    "profibus_off3_active",  // 10000000 Profibus OFF3 active
    "profibus_off2_active",  // 20000000 Profibus OFF2 active
    "profibus_off1_active",  // 40000000 Profibus OFF1 active
    "",  // 80000000 Reserved
}};
constexpr std::array<std::string_view, 32> warnings{{
    "reference_high",  // 00000001 Reference high
    "fault_in_eeprom_on_control_card",  // 00000002 Fault in EEprom on control card
    "fault_in_eeprom_on_power_card",  // 00000004 Fault in EEprom on power card
    "hpfb_bus_timeout",  // 00000008 HPFB bus timeout
    "serial_communication_timeout",  // 00000010 Serial communication timeout
    "overcurrent",  // 00000020 Overcurrent
    "current_limit",  // 00000040 Current limit
    "motor_thermistor",  // 00000080 Motor thermistor
    "motor_overtemperature",  // 00000100 Motor overtemperature
    "inverter_overtemperature",  // 00000200 Inverter overtemperature
    "undervoltage",  // 00000400 Undervoltage
    "overvoltage",  // 00000800 Overvoltage
    "voltage_warning_low",  // 00001000 Voltage warning low
    "voltage_warning_high",  // 00002000 Voltage warning high
    "mains_phase_fault",  // 00004000 Mains phase fault
    "live_zero_fault",  // 00008000 Live zero fault
    "under_10_volt",  // 00010000 Under 10 Volt (terminal 50)
    "reference_low",  // 00020000 Reference low
    "feedback_high",  // 00040000 Feedback high
    "feedback_low",  // 00080000 Feedback low
    "output_current_high",  // 00100000 Output current high
    "out_of_frequency_range",  // 00200000 Out of frequency range
    "profibus_communication_fault",  // 00400000 Profibus communication fault
    "output_current_low",  // 00800000 Output current low
    "output_frequency_high",  // 01000000 Output frequency high
    "output_frequency_low",  // 02000000 Output frequency low
    "ama_motor_too_small",  // 04000000 AMA - motor too small
    "ama_motor_too_big",  // 08000000 AMA - motor too big
    "ama_check_parameters_102_103_105",  // 10000000 AMA - check par. 102, 103, 105
    "ama_check_parameters_102_104_106",  // 20000000 AMA - check par. 102, 104, 106
    "",  // 40000000 Reserved
    "",  // 80000000 Reserved
}};
constexpr std::array<std::string_view, 29> alarms{{
    "unknown_fault",  // 00000001 Unknown fault
    "trip_locked",  // 00000002 Trip locked
    "auto_optimisation_not_ok",  // 00000004 Auto-optimisation not OK
    "hpfb_bus_timeout",  // 00000008 HPFB bus timeout
    "serial_communication_timeout",  // 00000010 Serial communication timeout
    "asic_fault",  // 00000020 ASIC fault
    "hpfp_bus_timeout",  // 00000040 HPFP bus timeout
    "standard_bus_timeout",  // 00000080 Standard bus timeout
    "short_circuiting",  // 00000100 Short-circuiting
    "switchmode_fault",  // 00000200 Switchmode fault
    "earth_fault",  // 00000400 Earth fault
    "current_limit",  // 00000800 Current limit
    "overcurrent",  // 00001000 Overcurrent
    "motor_thermistor",  // 00002000 Motor thermistor
    "motor_overheated",  // 00004000 Motor overheated
    "inverter_overheated",  // 00008000 Inverter overheated
    "undervoltage",  // 00010000 Undervoltage
    "overvoltage",  // 00020000 Overvoltage
    "mains_phase_fault",  // 00040000 Mains phase fault
    "live_zero_fault",  // 00080000 Live zero fault
    "heat_sink_temperature_too_high",  // 00100000 Heat sink temperature too high
    "motor_phase_w_missing",  // 00200000 Motor phase W missing
    "motor_phase_v_missing",  // 00400000 Motor phase V missing
    "motor_phase_u_missing",  // 00800000 Motor phase U missing
    "profibus_communication_fault",  // 01000000 Profibus communication fault
    "inverter_fault",  // 02000000 Inverter fault
    "output_current_low",  // 04000000 Output current low
    "safety_stop",  // 08000000 Safety stop
    "",  // 10000000 Reserved
}};
// clang-format on

template <typename Word, std::size_t N>
void expect_each_bit(std::array<std::string_view, N> const& names)
{
    EXPECT_EQ(text_of<Word>(0), "00000000");
    for (unsigned bit = 0; bit < 32; ++bit) {
        auto const number = hex<8>(1U << bit);
        auto const name   = bit < N and not names[bit].empty() ? std::string{names[bit]} : "+" + number;
        EXPECT_EQ(text_of<Word>(1U << bit), number + " " + name);
    }
}

template <typename Word, std::size_t N>
void expect_all_bits(std::array<std::string_view, N> const& names, std::string const& rest)
{
    std::string expected{"FFFFFFFF"};
    for (auto const name : names) {
        if (not name.empty()) { expected += " " + std::string{name}; }
    }
    EXPECT_EQ(text_of<Word>(0xFFFF'FFFF), expected + " +" + rest);
}

TEST(text_vlt6000_words, name_every_state_warning_and_alarm_of_the_manual)
{
    expect_each_bit<extended_status_word>(states);
    expect_each_bit<warning_word>(warnings);
    expect_each_bit<alarm_word>(alarms);
}

TEST(text_vlt6000_words, name_all_of_several)
{
    EXPECT_EQ(text_of<alarm_word>(0x0000'0402), "00000402 trip_locked earth_fault");
    EXPECT_EQ(text_of<warning_word>(0x0000'8020), "00008020 overcurrent live_zero_fault");
    EXPECT_EQ(text_of<extended_status_word>(0x0600'0600),
              "06000600 speed_equals_reference running drive_ready_25 control_ready");
    expect_all_bits<extended_status_word>(states, "80000000");
    expect_all_bits<warning_word>(warnings, "C0000000");
    expect_all_bits<alarm_word>(alarms, "F0000000");
}

constexpr bool writes(std::string_view expected, control_word word)
{
    std::array<char, 100>   room{};
    drivecodec::text_writer out{room};
    write_text(out, word);
    return out.view() == expected;
}

TEST(text_vlt6000_words, are_written_while_compiling)
{
    VERIFY(writes("CTW 043C ramp_stop preset_reference_1 setup_1", control_word::from_raw(0x043C)));
}

}  // namespace
