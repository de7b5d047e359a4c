// EXPECT: register_count_must_be_between.*1.*125
#include <drivecodec/modbus/functions/read_write_multiple_registers.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr auto asked = read_write_multiple_registers::of({0, 125}, 0, {1});
#else
constexpr auto asked = read_write_multiple_registers::of({0, 126}, 0, {1});
#endif
