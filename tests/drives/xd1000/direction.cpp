#include <drivecodec/drives/xd1000/direction.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::xd1000::direction;

TEST(xd1000_direction, is_0_forward_and_1_reverse)
{
    VERIFY(static_cast<int>(direction::forward) == 0 and static_cast<int>(direction::reverse) == 1);
}

}  // namespace
