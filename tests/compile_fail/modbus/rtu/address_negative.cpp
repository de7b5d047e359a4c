// EXPECT: server_address_must_be_between_1_and_247
#include <drivecodec/modbus/functions.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr auto frame = rtu::encode(255 - 254, write_single_register::request{.address = 1, .value = 2});
#else
constexpr auto frame = rtu::encode(1 - 256, write_single_register::request{.address = 1, .value = 2});
#endif
