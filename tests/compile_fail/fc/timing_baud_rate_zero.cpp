// EXPECT: baud_rate_must_be_positive
#include <drivecodec/fc/timing.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto made = timing::of(9600);
#else
constexpr auto made = timing::of(0);
#endif
