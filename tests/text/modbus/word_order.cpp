#include <drivecodec/text/modbus/word_order.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using drivecodec::modbus::character_order;
using drivecodec::modbus::word_order;

TEST(text_word_order, has_all_four_names)
{
    EXPECT_EQ(names_of_all_values<word_order>(), (std::set<std::string_view>{"abcd", "cdab", "badc", "dcba"}));
    VERIFY(to_string(word_order::badc) == "badc");
}

TEST(text_character_order, has_both_names)
{
    EXPECT_EQ(names_of_all_values<character_order>(),
              (std::set<std::string_view>{"high_byte_first", "low_byte_first"}));
    VERIFY(to_string(character_order::low_byte_first) == "low_byte_first");
}

}  // namespace
