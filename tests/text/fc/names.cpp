#include <drivecodec/text/fc/names.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec::fc;
using names = std::set<std::string_view>;

TEST(text_fc_names, of_commands)
{
    EXPECT_EQ(names_of_all_values<ak_command>(),
              (names{"no_command", "read_value", "write_word", "write_double_word", "read_description",
                     "write_double_word_to_eeprom", "write_word_to_eeprom", "text"}));
    VERIFY(to_string(ak_command{0x0}) == "no_command");
    VERIFY(to_string(ak_command{0x1}) == "read_value");
    VERIFY(to_string(ak_command{0x2}) == "write_word");
    VERIFY(to_string(ak_command{0x3}) == "write_double_word");
    VERIFY(to_string(ak_command{0x4}) == "read_description");
    VERIFY(to_string(ak_command{0xD}) == "write_double_word_to_eeprom");
    VERIFY(to_string(ak_command{0xE}) == "write_word_to_eeprom");
    VERIFY(to_string(ak_command{0xF}) == "text");
}

TEST(text_fc_names, of_replies)
{
    EXPECT_EQ(names_of_all_values<ak_reply>(),
              (names{"no_reply", "word", "double_word", "description", "cannot_be_executed", "text"}));
    VERIFY(to_string(ak_reply{0x0}) == "no_reply");
    VERIFY(to_string(ak_reply{0x1}) == "word");
    VERIFY(to_string(ak_reply{0x2}) == "double_word");
    VERIFY(to_string(ak_reply{0x3}) == "description");
    VERIFY(to_string(ak_reply{0x7}) == "cannot_be_executed");
    VERIFY(to_string(ak_reply{0xF}) == "text");
}

TEST(text_fc_names, of_data_types)
{
    EXPECT_EQ(names_of_all_values<data_type>(),
              (names{"integer_16", "integer_32", "unsigned_8", "unsigned_16", "unsigned_32", "text_string",
                     "byte_string", "time_difference", "reserved", "bit_sequence"}));
    VERIFY(to_string(data_type{3}) == "integer_16" and to_string(data_type{4}) == "integer_32");
    VERIFY(to_string(data_type{5}) == "unsigned_8" and to_string(data_type{6}) == "unsigned_16");
    VERIFY(to_string(data_type{7}) == "unsigned_32" and to_string(data_type{9}) == "text_string");
    VERIFY(to_string(data_type{10}) == "byte_string" and to_string(data_type{13}) == "time_difference");
    VERIFY(to_string(data_type{33}) == "reserved" and to_string(data_type{35}) == "bit_sequence");
}

TEST(text_fc_names, of_what_has_few_values)
{
    EXPECT_EQ(names_of_all_values<text_access>(), (names{"none", "read", "write"}));
    EXPECT_EQ(names_of_all_values<storage>(), (names{"ram", "ram_and_eeprom"}));
    EXPECT_EQ(names_of_all_values<width>(), (names{"word", "double_word"}));
    EXPECT_EQ(names_of_all_values<data_kind>(), (names{"process", "parameter", "text", "unknown"}));
    EXPECT_EQ(names_of_all_values<direction>(), (names{"unknown", "request", "response"}));
    EXPECT_EQ(names_of_all_values<expecting>(), (names{"either", "request", "response"}));
    EXPECT_EQ(names_of_all_values<address_format>(), (names{"short_1_to_31", "long_1_to_126"}));
    EXPECT_EQ(names_of_all_values<main_value>(), (names{"reference", "output_frequency"}));
    VERIFY(to_string(text_access{0x04}) == "read" and to_string(text_access{0x05}) == "write");
    VERIFY(to_string(storage::ram) == "ram" and to_string(width::word) == "word");
    VERIFY(to_string(data_kind::text) == "text" and to_string(direction::response) == "response");
    VERIFY(to_string(expecting::request) == "request");
    VERIFY(to_string(address_format::long_1_to_126) == "long_1_to_126");
    VERIFY(to_string(main_value::reference) == "reference");
}

}  // namespace
