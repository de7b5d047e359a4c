#include <drivecodec/drives/xd1000/table.hpp>

#include "support/verify.hpp"

#include <array>
#include <string_view>

namespace {

using namespace drivecodec;
using drives::source;

struct expected_row {
    unsigned         address;
    unsigned         hex;  // as the manual prints it beside the decimal; 0: it does not
    std::string_view menu;
    std::string_view code;
    bool             is_writable;
    int              exponent;
    unit             of;
    int              factory_setting;  // -1: not stated
};

/// From the manual, page by page: the menu of the port, the scanner, the example of function 03, the words.
constexpr std::array expected{
    expected_row{3102, 0x0C1E, "315", "", true, 2, unit::hertz, -1},
    expected_row{3103, 0x0C1F, "308", "", true, -1, unit::hertz, -1},
    expected_row{3104, 0x0C20, "512.2", "HSP", true, -1, unit::hertz, -1},
    expected_row{3105, 0x0C21, "512.0", "LSP", true, -1, unit::hertz, -1},
    expected_row{3201, 0x0C81, "", "ETA", false, 0, unit::none, -1},
    expected_row{3206, 0x0C86, "", "ETI", false, 0, unit::none, -1},
    expected_row{6001, 0x1771, "701", "", true, 0, unit::none, 0},
    expected_row{6003, 0x1773, "702", "", true, 0, unit::none, 32},
    expected_row{6004, 0x1774, "703", "", true, 0, unit::none, 3},
    expected_row{6005, 0x1775, "704", "", true, -1, unit::second, 100},
    expected_row{8501, 0x2135, "", "CMD", true, 0, unit::none, -1},
    expected_row{8504, 0x2138, "", "CMI", true, 0, unit::none, -1},
    expected_row{8602, 0x219A, "", "LFRD", true, 0, unit::revolution_per_minute, -1},
    expected_row{8604, 0x219C, "", "RFRD", false, 0, unit::revolution_per_minute, -1},
    expected_row{9001, 0x2329, "", "ACC", true, 0, unit::second, -1},
    expected_row{12701, 0x319D, "705.0", "NMA1", true, 0, unit::none, 3201},
    expected_row{12702, 0x319E, "705.1", "NMA2", true, 0, unit::none, 8604},
    expected_row{12703, 0x319F, "705.2", "NMA3", true, 0, unit::none, 0},
    expected_row{12704, 0x31A0, "705.3", "NMA4", true, 0, unit::none, 0},
    expected_row{12721, 0x31B1, "706.0", "NCA1", true, 0, unit::none, 8501},
    expected_row{12722, 0x31B2, "706.1", "NCA2", true, 0, unit::none, 8602},
    expected_row{12723, 0x31B3, "706.2", "NCA3", true, 0, unit::none, 0},
    expected_row{12724, 0x31B4, "706.3", "NCA4", true, 0, unit::none, 0},
    expected_row{12741, 0x31C5, "707.0", "NM1", false, 0, unit::none, -1},
    expected_row{12742, 0x31C6, "707.1", "NM2", false, 0, unit::none, -1},
    expected_row{12743, 0x31C7, "707.2", "NM3", false, 0, unit::none, -1},
    expected_row{12744, 0x31C8, "707.3", "NM4", false, 0, unit::none, -1},
    expected_row{12761, 0x31D9, "708.0", "NC1", true, 0, unit::none, -1},
    expected_row{12762, 0x31DA, "708.1", "NC2", true, 0, unit::none, -1},
    expected_row{12763, 0x31DB, "708.2", "NC3", true, 0, unit::none, -1},
    expected_row{12764, 0x31DC, "708.3", "NC4", true, 0, unit::none, -1},
};

TEST(xd1000_table, is_the_manual_s)
{
    ASSERT_EQ(xd1000::table.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        auto const& row    = xd1000::table[i];
        auto const& wanted = expected[i];
        EXPECT_EQ(row.address, wanted.address);
        EXPECT_EQ(wanted.hex, wanted.address);
        EXPECT_EQ(row.menu, wanted.menu) << row.address;
        EXPECT_EQ(row.code, wanted.code) << row.address;
        EXPECT_EQ(row.is_writable(), wanted.is_writable) << row.address;
        EXPECT_EQ(row.exponent, wanted.exponent) << row.address;
        EXPECT_EQ(row.unit, wanted.of) << row.address;
        EXPECT_EQ(row.factory_setting.from == source::nobody, wanted.factory_setting < 0) << row.address;
        if (wanted.factory_setting >= 0) {
            EXPECT_EQ(row.factory_setting.number, wanted.factory_setting) << row.address;
        }
    }
}

TEST(xd1000_table, has_factory_settings_within_the_limits)
{
    for (auto const& row : xd1000::table) {
        EXPECT_LE(row.limits.min, row.limits.max);
        EXPECT_TRUE(row.check(row.factory_setting.number).ok()) << row.address;
    }
}

TEST(xd1000_table, is_searched_by_address_code_menu_and_name)
{
    for (unsigned address = 0; address <= 0xFFFF; ++address) {
        auto const* found = xd1000::find(static_cast<std::uint16_t>(address));
        auto        is_in = false;
        for (auto const& row : expected) { is_in = is_in or row.address == address; }
        ASSERT_EQ(found != nullptr, is_in) << address;
        if (found != nullptr) { ASSERT_EQ(found->address, address); }
    }
    for (auto const& row : xd1000::table) {
        EXPECT_EQ(xd1000::find(row.name), &row);
        if (not row.code.empty()) { EXPECT_EQ(xd1000::find(row.code), &row); }
        if (not row.menu.empty()) { EXPECT_EQ(xd1000::find(row.menu), &row); }
    }
    VERIFY(xd1000::find("") == nullptr and xd1000::find("CM") == nullptr and xd1000::find("cmd ") == nullptr);
}

TEST(xd1000_table, has_every_name_once)
{
    for (auto const& a : xd1000::table) {
        for (auto const& b : xd1000::table) {
            if (&a == &b) { continue; }
            EXPECT_NE(a.name, b.name);
            EXPECT_TRUE(a.code != b.code or a.code.empty()) << a.code;
            EXPECT_TRUE(a.menu != b.menu or a.menu.empty()) << a.menu;
        }
    }
}

TEST(xd1000_manual, calls_register_8504_both_CPI_and_CMI)
{
    VERIFY(xd1000::find("CMI")->address == 8504 and xd1000::find("CPI") == nullptr);
}

TEST(xd1000_manual, calls_register_3206_EI_and_a_control_word_but_it_is_the_extended_status_word)
{
    VERIFY(xd1000::find("ETI")->address == 3206 and not xd1000::find("ETI")->is_writable());
}

TEST(xd1000_manual, has_no_unit_and_no_sign_for_speeds)
{
    for (auto const* code : {"LFRD", "RFRD"}) {
        EXPECT_EQ(xd1000::find(code)->scale_from, source::sister_drive);
        EXPECT_EQ(xd1000::find(code)->number(0xFFFF), -1);
    }
}

TEST(xd1000_manual, prints_addresses_with_a_leading_zero_that_are_not_octal)
{
    VERIFY(xd1000::find("701")->address == 6001);
}

TEST(xd1000_manual, labels_low_speed_by_its_code_and_others_by_their_menu)
{
    VERIFY(xd1000::find("LSP") == xd1000::find("512.0") and xd1000::find("LSP")->address == 3105);
}

}  // namespace
