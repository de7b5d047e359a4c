#include <drivecodec/drives/access.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::drives::access;  // by itself, for unistd.h has one, too

TEST(access, is_writable_unless_the_manual_says_no)
{
    VERIFY(is_writable(access::unknown) and is_writable(access::write_only));
    VERIFY(is_writable(access::read_write) and is_writable(access::read_write_at_standstill));
    VERIFY(not is_writable(access::read_only) and not is_writable(access::panel_only));
}

TEST(access, is_readable_unless_it_is_there_to_be_written)
{
    VERIFY(is_readable(access::unknown) and is_readable(access::read_only) and is_readable(access::panel_only));
    VERIFY(is_readable(access::read_write) and is_readable(access::read_write_at_standstill));
    VERIFY(not is_readable(access::write_only));
}

TEST(access, is_unknown_where_nothing_is_said)
{
    VERIFY(access{} == access::unknown);
}

}  // namespace
