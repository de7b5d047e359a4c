// EXPECT: a response holds at most 125 registers
#include <drivecodec/modbus/functions/read_registers.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr basic_read_holding_registers<125>::request asked{.range = {0, 1}};
#else
constexpr basic_read_holding_registers<126>::request asked{.range = {0, 1}};
#endif
