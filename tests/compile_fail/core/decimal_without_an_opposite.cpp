// EXPECT: overflow|outside the range|not a constant
#include <drivecodec/core/quantity.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto opposite = -decimal{-2147483647, 0};
#else
constexpr auto opposite = -decimal{-2147483647 - 1, 0};
#endif
