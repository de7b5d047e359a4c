// EXPECT: range_must_end_at_or_before_address_65535
#include <drivecodec/modbus/address_range.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr register_range<125> range{0, 2};
#else
constexpr register_range<125> range{-1, 2};
#endif
