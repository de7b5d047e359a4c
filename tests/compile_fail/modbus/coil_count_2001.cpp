// EXPECT: coil_count_must_be_between.*1.*2000
#include <drivecodec/modbus/address_range.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr coil_range<2000> range{0, 2000};
#else
constexpr coil_range<2000> range{0, 2001};
#endif
