// EXPECT: register_count_must_be_between.*1.*125
#include <drivecodec/modbus/functions/read_registers.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr read_holding_registers::basic_response<register_array<125>> given{.values = register_array<125>{}};
#else
constexpr read_holding_registers::basic_response<register_array<126>> given{.values = register_array<126>{}};
#endif
