// EXPECT: register_count_must_be_between.*1.*63
#include <drivecodec/modbus/functions/read_registers.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr basic_read_holding_registers<63>::request asked{.range = {0, 63}};
#else
constexpr basic_read_holding_registers<63>::request asked{.range = {0, 64}};
#endif
