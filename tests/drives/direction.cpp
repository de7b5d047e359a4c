#include <drivecodec/drives/direction.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::drives::direction;

TEST(drives_direction, is_0_forward_and_1_reverse)
{
    VERIFY(static_cast<int>(direction::forward) == 0 and static_cast<int>(direction::reverse) == 1);
}

}  // namespace
