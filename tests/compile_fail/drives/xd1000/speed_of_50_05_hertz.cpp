// EXPECT: the_value_has_more_digits_than_the_register_or_parameter_can_hold
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr auto no = high_speed.write(50.0_Hz);
#else
constexpr auto no = high_speed.write(50.05_Hz);
#endif
