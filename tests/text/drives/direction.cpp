#include <drivecodec/text/drives/direction.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using drivecodec::drives::direction;

TEST(text_direction, has_a_name_for_both)
{
    EXPECT_EQ(names_of_all_values<direction>(), (std::set<std::string_view>{"forward", "reverse"}));
    VERIFY(to_string(direction::reverse) == "reverse");
}

}  // namespace
