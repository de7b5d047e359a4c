#include <drivecodec/text/drives/xd1000/names.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec::xd1000;

TEST(text_xd1000, has_a_name_for_every_enumerator)
{
    EXPECT_EQ(names_of_all_values<baud_rate>(),
              (std::set<std::string_view>{"baud_4800", "baud_9600", "baud_19200", "baud_38400"}));
    EXPECT_EQ(names_of_all_values<character_format>(),
              (std::set<std::string_view>{"format_8o1", "format_8e1", "format_8n1", "format_8n2"}));
    VERIFY(to_string(baud_rate::baud_19200) == "baud_19200" and to_string(baud_rate{19}).empty());
    VERIFY(to_string(character_format::format_8o1) == "format_8o1");
}

}  // namespace
