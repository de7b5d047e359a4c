#include <drivecodec/core/platform.hpp>

#include "support/verify.hpp"

namespace {

TEST(platform, of_these_tests_is_a_host)
{
    VERIFY(drivecodec::is_host);
}

}  // namespace
