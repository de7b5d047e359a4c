// EXPECT: no match for|invalid operands
#include <drivecodec/core/quantity.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr bool less = 50_Hz < 50.1_Hz;
#else
constexpr bool less = 50_Hz < 50.1_s;
#endif
