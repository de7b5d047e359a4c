// EXPECT: address_0_is_the_broadcast_write_rtu_broadcast
#include <drivecodec/modbus/functions.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr auto frame = rtu::encode(rtu::broadcast, write_single_register::request{.address = 1, .value = 2});
#else
constexpr auto frame = rtu::encode(0, write_single_register::request{.address = 1, .value = 2});
#endif
