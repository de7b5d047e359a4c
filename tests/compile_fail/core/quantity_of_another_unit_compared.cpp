// EXPECT: no match for|invalid operands
#include <drivecodec/core/quantity.hpp>

using namespace drivecodec::literals;

#ifdef OK
static_assert(50_Hz == 50.0_Hz);
#else
static_assert(50_Hz == 50_s);
#endif
