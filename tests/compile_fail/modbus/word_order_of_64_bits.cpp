// EXPECT: two_registers
#include <drivecodec/modbus/word_order.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr auto words = to_registers(1.5F, word_order::abcd);
#else
constexpr auto words = to_registers(1.5, word_order::abcd);
#endif
