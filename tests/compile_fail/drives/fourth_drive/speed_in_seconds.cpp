// EXPECT: cannot convert|could not convert|no viable conversion|no matching|no known conversion
#include "drives/fourth_drive/pump.hpp"

using namespace drivecodec::literals;

#ifdef OK
constexpr auto no = pump::speed_reference.write(50_Hz);
#else
constexpr auto no = pump::speed_reference.write(50_s);
#endif
