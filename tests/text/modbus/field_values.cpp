#include <drivecodec/text/modbus/field_values.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

namespace modbus = drivecodec::modbus;

TEST(text_field_values, are_those_of_the_wire)
{
    VERIFY(static_cast<int>(modbus::coil_value::on) == 0xFF00);
    VERIFY(static_cast<int>(modbus::program_status::busy) == 0xFFFF);
    VERIFY(static_cast<int>(modbus::more_follows::yes) == 0xFF);
}

TEST(text_field_values, have_names)
{
    EXPECT_EQ(names_of_all_values<modbus::coil_value>(), (std::set<std::string_view>{"on", "off"}));
    EXPECT_EQ(names_of_all_values<modbus::program_status>(), (std::set<std::string_view>{"ready", "busy"}));
    EXPECT_EQ(names_of_all_values<modbus::more_follows>(), (std::set<std::string_view>{"no", "yes"}));
    VERIFY(to_string(modbus::coil_value::on) == "on");
    VERIFY(to_string(modbus::program_status::ready) == "ready");
    VERIFY(to_string(modbus::more_follows::no) == "no");
}

TEST(text_field_values, of_bits_have_none)
{
    EXPECT_TRUE(names_of_all_values<modbus::bits_8>().empty());
    EXPECT_TRUE(names_of_all_values<modbus::bits_16>().empty());
}

}  // namespace
