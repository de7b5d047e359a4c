// EXPECT: this_register_or_parameter_is_read_only
#include "drives/fourth_drive/pump.hpp"

using namespace drivecodec::literals;

#ifdef OK
constexpr auto no = pump::status.read();
#else
constexpr auto no = pump::status.write({});
#endif
