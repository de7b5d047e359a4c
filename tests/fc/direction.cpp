#include <drivecodec/fc/direction.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::fc::direction;

// Nothing in a telegram says it: what is not set is not known.
TEST(direction, is_unknown_unless_somebody_finds_out)
{
    VERIFY(direction{} == direction::unknown);
    VERIFY(direction::request != direction::unknown and direction::response != direction::unknown);
    VERIFY(direction::request != direction::response);
}

}  // namespace
