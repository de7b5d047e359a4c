#include <drivecodec/text/drives/register_row.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

#include <array>
#include <string>

namespace {

using namespace drivecodec;
using drives::raw_type;
using drives::register_row;
using drives::source;

constexpr register_row row(raw_type type, int exponent, unit of, std::string_view code = {})
{
    return {1,
            "name",
            "",
            code,
            type,
            static_cast<std::int8_t>(exponent),
            of,
            source::manual,
            drives::no_limits_unsigned,
            drives::no_default,
            drives::access::read_write,
            source::manual};
}

constexpr bool reads(register_row const& what, std::uint16_t raw, std::string_view expected)
{
    std::array<char, 100> room{};
    text_writer           out{room};
    write_value(out, what, raw);
    return out.view() == expected;
}

TEST(text_register_row, has_a_name_for_every_enumerator)
{
    EXPECT_EQ(names_of_all_values<raw_type>().size(), 7);
    EXPECT_EQ(names_of_all_values<source>().size(), 3);
    VERIFY(to_string(raw_type::register_address) == "register_address");
    VERIFY(to_string(raw_type::two_bytes) == "two_bytes" and to_string(raw_type::text) == "text");
    VERIFY(to_string(source::sister_drive) == "sister_drive");
}

TEST(text_register_row, writes_a_number_as_what_it_counts)
{
    VERIFY(reads(row(raw_type::unsigned_number, -1, unit::hertz), 500, "50.0 Hz"));
    VERIFY(reads(row(raw_type::unsigned_number, 0, unit::second), 13, "13 s"));
    VERIFY(reads(row(raw_type::unsigned_number, 0, unit::none), 0xFFFF, "65535"));
    VERIFY(reads(row(raw_type::signed_number, 0, unit::revolution_per_minute), 0xFA24, "-1500 rpm"));
}

TEST(text_register_row, writes_16_bits_of_a_register_that_no_table_has)
{
    std::array<char, 40> room{};
    text_writer          out{room};
    drives::write_unknown_register(out, 5000, 5000);
    EXPECT_EQ(out.view(), "register 5000: 1388");
}

TEST(text_register_row, writes_each_unit_as_a_quantity_of_it)
{
    std::array<char, 100> room{};
    for (auto which = 0U; which <= static_cast<unsigned>(unit::newton_metre); ++which) {
        text_writer out{room};
        write_value(out, row(raw_type::unsigned_number, -2, static_cast<unit>(which)), 7);
        auto const symbol = std::string{to_string(static_cast<unit>(which))};
        EXPECT_EQ(std::string{out.view()}, which == 0 ? "0.07" : "0.07 " + symbol);
    }
}

TEST(text_register_row, writes_bits_in_hexadecimal_and_calls_them_by_their_code)
{
    VERIFY(reads(row(raw_type::bits, 0, unit::none), 0x0637, "0637"));
    VERIFY(reads(row(raw_type::two_bytes, 0, unit::none), 0x6406, "6406"));
    VERIFY(reads(row(raw_type::text, 0, unit::none), 0x534D, "534D"));
    VERIFY(reads(row(raw_type::enumeration, 0, unit::none), 32, "32"));
    VERIFY(title(row(raw_type::bits, 0, unit::none, "CMD")) == "CMD");
    VERIFY(title(row(raw_type::bits, 0, unit::none)) == "name");
    VERIFY(title(row(raw_type::unsigned_number, 0, unit::none, "ACC")) == "name");
}

}  // namespace
