// EXPECT: range_must_end_at_or_before_address_65535
#include <drivecodec/modbus/functions/write_multiple_registers.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr auto written = write_multiple_registers::of(0xFFFE, {1, 2});
#else
constexpr auto written = write_multiple_registers::of(0xFFFF, {1, 2});
#endif
