#include <drivecodec/drives/smd/map.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;

constexpr smd::map pv400{smd::pv400};
constexpr smd::map pv507{smd::pv507};

TEST(smd_map, is_made_of_register_50_and_refuses_other_drives)
{
    VERIFY(*smd::map::make(400) == pv400 and *smd::map::make(507) == pv507);
    VERIFY(smd::map::make(507)->version() == smd::pv507);
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const made = smd::map::make(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(made.has_value(), raw == 400 or raw == 507);
        if (not made) { ASSERT_EQ(made.error(), (error{errc::bad_value, 0})); }
    }
}

template <smd::version Version>
void finds_every_row(smd::map map)
{
    for (auto const& row : smd::table<Version>) {
        EXPECT_EQ(map.find(row.address), &row);
        EXPECT_EQ(map.find(row.name), &row);
        if (not row.code.empty()) { EXPECT_EQ(map.find(row.code), &row); }
    }
}

TEST(smd_map, finds_by_address_code_and_name)
{
    finds_every_row<smd::pv400>(pv400);
    finds_every_row<smd::pv507>(pv507);
    VERIFY(pv400.find("C12")->address == 61 and pv507.find("acceleration_time")->code == "C12");
    VERIFY(pv400.find("C31") == nullptr and pv507.find("C31")->address == 71);
    VERIFY(pv507.find("") == nullptr and pv507.find("C1") == nullptr and pv507.find("C123") == nullptr);
}

TEST(smd_map, has_case_sensitive_codes)
{
    VERIFY(pv507.find("C01")->address == 51 and pv507.find("c01")->address == 96);
    VERIFY(pv507.find("C70")->address == 89 and pv507.find("c70")->address == 113);
    VERIFY(pv507.find("ce1") == nullptr and pv507.find("N22") == nullptr);
    VERIFY(pv400.find("c01") == nullptr);
}

TEST(smd_map, finds_no_other_code_of_three_characters)
{
    unsigned found = 0;
    for (unsigned raw = 0; raw < 0x80'0000; ++raw) {
        std::array<char, 3> const code{static_cast<char>(raw >> 16), static_cast<char>(raw >> 8 & 0x7F),
                                       static_cast<char>(raw & 0x7F)};
        if ((raw & 0x8080) == 0) { found += pv507.find({code.data(), 3}) != nullptr ? 1U : 0U; }
    }
    EXPECT_EQ(found, 67U);
}

TEST(smd_map, writes_physical_values)
{
    VERIFY(pv400.make_write("C12", {50, -1})->address == 61 and pv400.make_write("C12", {5, 0})->value == 50);
    VERIFY(pv400.make_write("n23", {100, -3})->address == 114 + 1 and pv507.make_write("n23", {1, -1})->value == 100);
    VERIFY(pv507.make_write("C11", {74, -1}).error() == error{errc::out_of_range, 0});
    VERIFY(pv507.make_write("C12", {55, -2}).error() == error{errc::inexact, 0});
    VERIFY(pv507.make_write("C46", {1, 0}).error() == error{errc::read_only, 0});
    VERIFY(pv400.make_write("C31", {1, 0}).error() == error{errc::bad_address, 0});
}

TEST(smd_map, checks_every_write)
{
    for (auto const map : {pv400, pv507}) {
        for (unsigned address = 0; address <= 200; ++address) {
            auto const at = static_cast<std::uint16_t>(address);
            for (unsigned raw = 0; raw <= 0xFFFF; raw += 0x11) {
                auto const  value = static_cast<std::uint16_t>(raw);
                auto const* row   = map.find(at);
                auto const  made  = map.make_write(at, value);
                ASSERT_EQ(made.has_value(), map.check_write(at, value).ok());
                if (row == nullptr) {
                    ASSERT_EQ(made.error(), (error{errc::bad_address, 0}));
                } else if (not row->is_writable()) {
                    ASSERT_EQ(made.error(), (error{errc::read_only, 0}));
                } else if (made) {
                    ASSERT_EQ(*made, (smd::write_single_register::request{at, value}));
                }
            }
        }
    }
    VERIFY(pv507.check_write(24, 1) == error{errc::read_only, 0});
    VERIFY(pv507.check_write(58, 0) == error{errc::out_of_range, 0} and pv507.check_write(58, 247).ok());
}

TEST(smd_map, reads_one_register_6_at_24_and_4_at_its_own_C99)
{
    VERIFY(pv507.make_read(24, 6) and pv507.make_read(24) and pv507.make_read(95, 4) and pv400.make_read(89, 4));
    VERIFY(pv507.make_read(89, 4).error() == error{errc::bad_quantity, 0});
    VERIFY(pv400.make_read(95, 4).error() == error{errc::bad_quantity, 0});
    VERIFY(pv507.make_read(60, 2).error() == error{errc::bad_quantity, 0});
    VERIFY(pv507.make_read(24, 7).error() == error{errc::bad_quantity, 0});
    VERIFY(pv507.make_read(24, 0).error() == error{errc::bad_quantity, 0});
    VERIFY(pv507.make_read(56).error() == error{errc::bad_address, 0});
    for (auto const address : std::array<std::uint16_t, 3>{1, 48, 49}) {  // write only
        EXPECT_EQ(pv507.make_read(address).error(), (error{errc::bad_address, 0}));
    }
}

}  // namespace
