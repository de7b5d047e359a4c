// EXPECT: the_value_must_be_between_min_and_max_times_ten_to_the_exponent.*(Min = 0; int Max = 247|<0, 247, 0>)
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr auto no = modbus_address.write(247);
#else
constexpr auto no = modbus_address.write(248);
#endif
