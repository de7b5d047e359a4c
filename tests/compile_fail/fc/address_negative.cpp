// EXPECT: address_must_be_between_1_and_31_in_the_short_format
#include <drivecodec/fc/address.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto first = address::short_format(1);
#else
constexpr auto first = address::short_format(-1);
#endif
