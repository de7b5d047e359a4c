// EXPECT: server_address_must_be_between_1_and_247
#include <drivecodec/modbus/rtu/address.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr rtu::server_address last = 247;
#else
constexpr rtu::server_address last = 248;
#endif
