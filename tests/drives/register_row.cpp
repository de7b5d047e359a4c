#include <drivecodec/drives/register_row.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec;
using namespace drivecodec::drives;

constexpr std::array<std::uint16_t, 2> choices{3, 5};

constexpr register_row row_of(std::uint16_t address, raw_type type, raw_limits limits, drives::access may,
                              std::span<std::uint16_t const> codes = {})
{
    return {address, "", "", "", type, 0, unit::none, source::manual, limits, no_default, may, source::manual, codes};
}

constexpr register_table<5> table{
    row_of(10, raw_type::unsigned_number, {1, 300, source::manual}, drives::access::read_write),
    row_of(11, raw_type::signed_number, {-5, 5, source::manual}, drives::access::read_write_at_standstill),
    row_of(12, raw_type::bits, no_limits_unsigned, drives::access::read_only),
    row_of(20, raw_type::enumeration, {3, 5, source::manual}, drives::access::read_write, choices),
    row_of(21, raw_type::two_bytes, no_limits_unsigned, drives::access::write_only),
};

TEST(register_row, has_what_the_type_allows_where_nothing_is_said)
{
    constexpr register_row bare{.address = 1};
    VERIFY(bare.name.empty() and bare.menu.empty() and bare.code.empty() and bare.choices.empty());
    VERIFY(bare.type == raw_type::unsigned_number and bare.exponent == 0 and bare.unit == unit::none);
    VERIFY(bare.scale_from == source::nobody and bare.limits.from == source::nobody);
    VERIFY(bare.factory_setting.from == source::nobody and bare.access_from == source::nobody);
    VERIFY(bare.access == drives::access::unknown and bare.is_readable() and bare.is_writable());
    VERIFY(bare.check_write(0).ok() and bare.check_write(0xFFFF).ok());
}

TEST(register_row, reads_16_bits_as_its_type_says)
{
    VERIFY(table[0].number(0xFFFF) == 65535 and table[1].number(0xFFFF) == -1 and table[2].number(0x8000) == 0x8000);
}

TEST(register_row, takes_what_is_within_its_limits)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = static_cast<std::uint16_t>(raw);
        ASSERT_EQ(table[0].check_write(word).ok(), raw >= 1 and raw <= 300) << raw;
        ASSERT_EQ(table[1].check_write(word).ok(), raw <= 5 or raw >= 0xFFFB) << raw;
        ASSERT_EQ(table[2].check_write(word).code(), errc::read_only) << raw;
        ASSERT_EQ(table[3].check_write(word).ok(), raw == 3 or raw == 5) << raw;
    }
}

TEST(register_row, is_written_or_read_as_its_access_says)
{
    VERIFY(table[0].is_readable() and table[0].is_writable());
    VERIFY(table[1].is_readable() and table[1].is_writable());
    VERIFY(table[2].is_readable() and not table[2].is_writable());
    VERIFY(not table[4].is_readable() and table[4].is_writable());
    VERIFY(table[4].check_write(0x1234).ok() and table[4].number(0x8001) == 0x8001);
}

TEST(register_row, makes_16_bits_of_a_physical_value)
{
    constexpr auto seconds = [] {
        auto row     = table[0];
        row.exponent = -1;
        return row;
    }();
    VERIFY(*seconds.make_raw({50, -1}) == 50 and *seconds.make_raw({5, 0}) == 50
           and *seconds.make_raw({500, -2}) == 50);
    VERIFY(seconds.make_raw({501, -2}).error() == error{errc::inexact, 0});
    VERIFY(seconds.make_raw({301, -1}).error() == error{errc::out_of_range, 0});
    VERIFY(seconds.make_raw({0, 0}).error() == error{errc::out_of_range, 0});
    VERIFY(seconds.make_raw({2'000'000'000, 3}).error() == error{errc::out_of_range, 0});
    VERIFY(*table[1].make_raw({-5, 0}) == 0xFFFB);
    VERIFY(table[3].make_raw({4, 0}).error() == error{errc::out_of_range, 0});
}

TEST(register_table, has_no_gap_that_can_be_read)
{
    VERIFY(check_range(table, 10, 3).ok());
    VERIFY(check_range(table, 10, 4) == error{errc::bad_address, 3});
    VERIFY(check_range(table, 13, 1) == error{errc::bad_address, 0});
    VERIFY(check_range(table, 0xFFFF, 2) == error{errc::bad_address, 0});
    VERIFY(check_range(table, 10, 0).ok());
}

TEST(register_table, says_which_value_it_does_not_take)
{
    VERIFY(check_write(table, 10, std::array<std::uint16_t, 2>{300, 5}).ok());
    VERIFY(check_write(table, 10, std::array<std::uint16_t, 2>{301, 5}) == error{errc::out_of_range, 0});
    VERIFY(check_write(table, 10, std::array<std::uint16_t, 2>{300, 6}) == error{errc::out_of_range, 1});
    VERIFY(check_write(table, 10, std::array<std::uint16_t, 3>{300, 5, 0}) == error{errc::read_only, 2});
    VERIFY(check_write(table, 21, std::array<std::uint16_t, 2>{3, 0}) == error{errc::bad_address, 1});
}

TEST(register_table, finds_by_address)
{
    VERIFY(find(table, std::uint16_t{20}) == &table[3] and find(table, std::uint16_t{13}) == nullptr);
}

}  // namespace
