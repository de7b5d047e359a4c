// EXPECT: address_0_is_no_slave_a_broadcast_is_written_as_such
#include <drivecodec/fc/address.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto all = long_broadcast;
#else
constexpr auto all = address::long_format(0);
#endif
