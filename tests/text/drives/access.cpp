#include <drivecodec/text/drives/access.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using drivecodec::drives::access;  // by itself, for unistd.h has one, too

TEST(access_text, is_the_name)
{
    VERIFY(to_string(access::unknown) == "unknown" and to_string(access::read_only) == "read_only");
    VERIFY(to_string(access::read_write) == "read_write" and to_string(access::write_only) == "write_only");
    VERIFY(to_string(access::read_write_at_standstill) == "read_write_at_standstill");
    VERIFY(to_string(access::panel_only) == "panel_only");
}

TEST(access_text, is_empty_for_all_other_numbers)
{
    EXPECT_EQ(names_of_all_values<access>().size(), 6);
}

}  // namespace
