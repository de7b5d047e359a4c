// EXPECT: the_value_must_be_between_min_and_max_times_ten_to_the_exponent.*(Min = 0; int Max = 600; int Exponent = -1|<0, 600, -1>)
#include "drives/fourth_drive/pump.hpp"

using namespace drivecodec::literals;

#ifdef OK
constexpr auto no = pump::speed_reference.write(60.0_Hz);
#else
constexpr auto no = pump::speed_reference.write(60.1_Hz);
#endif
