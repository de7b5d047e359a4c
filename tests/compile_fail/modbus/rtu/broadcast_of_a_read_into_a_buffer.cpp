// EXPECT: only a write can be broadcast: nobody answers a broadcast
#include <drivecodec/modbus/functions.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec::modbus;

auto encode(drivecodec::mutable_bytes out)
{
#ifdef OK
    return rtu::encode(rtu::broadcast, write_single_register::request{.address = 1, .value = 2}, out);
#else
    return rtu::encode(rtu::broadcast, read_holding_registers::request{{1, 2}}, out);
#endif
}
