// EXPECT: must have adjacent addresses, in ascending order, without a gap|static_assert failed due to requirement
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr auto no = registers<high_speed, low_speed>::read();
#else
constexpr auto no = registers<low_speed, high_speed>::read();
#endif
