// EXPECT: the_value_is_none_of_those_that_the_register_or_parameter_takes
#include "drives/fourth_drive/pump.hpp"

using namespace drivecodec::literals;

#ifdef OK
constexpr auto no = pump::operating_mode.write(pump::mode{2});
#else
constexpr auto no = pump::operating_mode.write(pump::mode{3});
#endif
