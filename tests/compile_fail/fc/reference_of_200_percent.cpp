// EXPECT: the_main_value_must_be_between_minus_and_plus_199_994_percent
#include <drivecodec/fc/main_value.hpp>

using namespace drivecodec::fc;
using namespace drivecodec::literals;

#ifdef OK
constexpr reference most = 199.994_percent;
#else
constexpr reference most = 200_percent;
#endif
