#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/smd/fault.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

#include <array>
#include <string>

namespace {

using namespace drivecodec::smd;
using drivecodec::describe;

struct printed_row {
    std::string_view name;
    std::string_view display;
};

/// smd manual, table 16 and, with the same rows, table 18; by number.
constexpr std::array<printed_row, 27> printed{{
    {"no_fault", ""},
    {"output_transistor_fault", "OC1"},
    {"high_drive_temperature", "OH"},
    {"high_dc_bus_voltage", "OU"},
    {"low_dc_bus_voltage", "LU"},
    {"thermal_overload", "OC6"},
    {"control_fault", "CF"},
    {"external_fault", "EEr"},
    {"serial_communication_failure", "FC5"},
    {"start_error", "LC"},
    {"internal_fault_1_epm", "F1"},
    {"internal_fault_2", "F2"},
    {"internal_fault_3", "F3"},
    {"internal_fault_4", "F4"},
    {"internal_fault_5", "F5"},
    {"internal_fault_6", "F6"},
    {"internal_fault_7", "F7"},
    {"internal_fault_8", "F8"},
    {"internal_fault_9", "F9"},
    {"internal_fault_o", "Fo"},
    {"single_phase_fault", "SF"},
    {"incompatibility_fault", "cF"},
    {"dynamic_brake_overheated", "dF"},
    {"remote_keypad_fault", "JF"},
    {"communication_fault", "FC3"},
    {"earth_fault", "OC2"},
    {"configuration_fault", "CFG"},
}};

std::string text_of(unsigned code)
{
    std::array<char, 60> room{};
    return std::string{describe(fault{static_cast<std::uint16_t>(code)}, room)};
}

TEST(text_smd_fault, has_the_manual_s_number_name_and_display)
{
    for (std::size_t number = 0; number < printed.size(); ++number) {
        auto const code = static_cast<fault>(number);
        EXPECT_EQ(to_string(code), printed[number].name);
        EXPECT_EQ(display_text(code), printed[number].display);
    }
    EXPECT_EQ(names_of_all_values<fault>().size(), printed.size());
    VERIFY(display_text(fault::communication_fault) == "FC3" and to_string(fault{24}) == "communication_fault");
}

TEST(smd_manual, quotes_two_display_texts_in_one_table_only)
{
    VERIFY(display_text(fault::earth_fault) == "OC2" and display_text(fault::configuration_fault) == "CFG");
}

TEST(smd_manual, names_a_fault_GF_that_its_tables_do_not_have_and_two_that_differ_in_a_letter_s_case)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const shown = display_text(fault{static_cast<std::uint16_t>(raw)});
        ASSERT_NE(shown, "GF");
        ASSERT_EQ(shown == "CF", raw == 6);
        ASSERT_EQ(shown == "cF", raw == 21);
    }
}

TEST(smd_manual, lets_c61_show_texts_that_are_no_fault_codes)
{
    for (auto const& row : printed) { EXPECT_TRUE(row.display != "Inh" and row.display != "Stp"); }
}

TEST(text_smd_fault, is_name_number_and_display)
{
    EXPECT_EQ(text_of(0), "no_fault");
    EXPECT_EQ(text_of(24), "communication_fault 24 FC3");
    EXPECT_EQ(text_of(8), "serial_communication_failure 8 FC5");
    EXPECT_EQ(text_of(27), "fault 27");
    EXPECT_EQ(text_of(65535), "fault 65535");
}

}  // namespace
