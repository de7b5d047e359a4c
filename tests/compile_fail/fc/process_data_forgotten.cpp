// EXPECT: no matching function|too few arguments
#include <drivecodec/fc/parameter_requests.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto asked = read_value(202, data_not_valid);
#else
constexpr auto asked = read_value(202);
#endif
