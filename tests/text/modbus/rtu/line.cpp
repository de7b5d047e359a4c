#include <drivecodec/text/modbus/rtu/line.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

#include <array>

namespace {

namespace rtu = drivecodec::modbus::rtu;

constexpr bool reads(rtu::character_format format, std::string_view expected)
{
    std::array<char, 10>    buffer{};
    drivecodec::text_writer out{buffer};
    write_text(out, format);
    return out.view() == expected;
}

TEST(text_rtu_line, has_a_name_for_every_enumerator)
{
    EXPECT_EQ(names_of_all_values<rtu::parity>(), (std::set<std::string_view>{"none", "even", "odd"}));
    EXPECT_EQ(names_of_all_values<rtu::stop_bits>(), (std::set<std::string_view>{"one", "two"}));
    EXPECT_EQ(names_of_all_values<rtu::expecting>(), (std::set<std::string_view>{"either", "request", "response"}));
    VERIFY(to_string(rtu::parity::odd) == "odd");
    VERIFY(to_string(rtu::stop_bits::two) == "two");
    VERIFY(to_string(rtu::expecting::request) == "request");
}

TEST(text_rtu_line, writes_formats_as_people_do)
{
    VERIFY(reads(rtu::format_8e1, "8E1"));
    VERIFY(reads(rtu::format_8o1, "8O1"));
    VERIFY(reads(rtu::format_8n2, "8N2"));
    VERIFY(reads(rtu::format_8n1, "8N1"));
}

}  // namespace
