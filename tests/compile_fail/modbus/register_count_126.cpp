// EXPECT: register_count_must_be_between.*1.*125
#include <drivecodec/modbus/address_range.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr register_range<125> range{0, 125};
#else
constexpr register_range<125> range{0, 126};
#endif
