// EXPECT: only a write can be broadcast: nobody answers a broadcast
#include <drivecodec/modbus/functions.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr auto frame = rtu::encode(rtu::broadcast, write_multiple_registers::of(1, {2, 3}));
#else
constexpr auto frame = rtu::encode(rtu::broadcast, read_holding_registers::request{{1, 2}});
#endif
