// EXPECT: address_must_be_between_1_and_31_in_the_short_format
#include <drivecodec/fc/address.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto last = address::short_format(31);
#else
constexpr auto last = address::short_format(32);
#endif
