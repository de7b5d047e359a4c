// EXPECT: address_must_be_between_1_and_126_in_the_long_format
#include <drivecodec/fc/address.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto last = address::long_format(126);
#else
constexpr auto last = address::long_format(127);
#endif
