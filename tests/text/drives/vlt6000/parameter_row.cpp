#include <drivecodec/text/drives/vlt6000/parameter_row.hpp>

#include <drivecodec/drives/vlt6000/table.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec;
using vlt6000::find;
using vlt6000::kind;

constexpr bool reads(vlt6000::parameter_row const& row, std::uint32_t transferred, std::string_view expected)
{
    std::array<char, 40> room{};
    text_writer          out{room};
    write_value(out, row, transferred);
    return out.view() == expected;
}

TEST(text_vlt6000_parameter_row, has_a_name_for_every_enumerator)
{
    EXPECT_EQ(names_of_all_values<kind>(), (std::set<std::string_view>{"unknown", "number", "choice", "bits", "text"}));
    VERIFY(to_string(kind::unknown) == "unknown" and to_string(kind::number) == "number");
    VERIFY(to_string(kind::choice) == "choice" and to_string(kind::bits) == "bits");
    VERIFY(to_string(kind::text) == "text");
}

TEST(text_vlt6000_parameter_row, writes_a_number_of_known_scale_with_its_unit)
{
    VERIFY(reads(*find(202), 0x03E8, "100.0 Hz"));
    VERIFY(reads(*find(201), 100, "10.0 Hz"));
    VERIFY(reads(*find(206), 0x000A, "10 s"));
    VERIFY(reads(*find(202), 0, "0.0 Hz"));
    VERIFY(reads(*find(202), 0xFFFF, "6553.5 Hz"));
    VERIFY(reads({.number = 1, .conversion_index = -2, .unit = unit::watt, .unit_prefix = 3}, 150, "1.50 kW"));
}

TEST(text_vlt6000_parameter_row, writes_a_number_of_unknown_scale_without_one)
{
    VERIFY(reads(*find(512), 500, "500") and reads(*find(515), 75, "75") and reads(*find(555), 1, "1"));
    VERIFY(reads(*find(500), 2, "2") and reads(*find(415), 20, "20") and reads(*find(615), 14, "14"));
    VERIFY(reads(*find(512), 0xFFFF'FFFF, "4294967295"));
    VERIFY(reads(*find(103), 7, "7"));
}

TEST(text_vlt6000_parameter_row, writes_what_no_decimal_can_hold_as_it_is)
{
    VERIFY(reads(*find(206), 0x7FFF'FFFF, "2147483647 s"));
    VERIFY(reads(*find(206), 0x8000'0000, "2147483648"));
}

TEST(text_vlt6000_parameter_row, writes_bits_in_hexadecimal)
{
    VERIFY(reads(*find(527), 0x0F03, "0F03") and reads(*find(530), 0x047F, "047F"));
    VERIFY(reads(*find(532), 0x0000'0400, "00000400") and reads(*find(529), 0x0800'0000, "08000000"));
    VERIFY(reads(*find(531), 0, "00000000") and reads(*find(521), 0x88, "0088"));
    VERIFY(reads(*find(527), 0x1'0000, "00010000"));
}

}  // namespace
