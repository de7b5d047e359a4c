// EXPECT: the_smd_has_an_address_between_1_and_247_and_takes_no_broadcast
#include <drivecodec/drives/smd/link.hpp>

using namespace drivecodec;

#ifdef OK
constexpr smd::link_settings no{.address = 1};
#else
constexpr smd::link_settings no{.address = 0};
#endif
