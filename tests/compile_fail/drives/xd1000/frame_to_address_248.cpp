// EXPECT: server_address_must_be_between_1_and_247
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#include <drivecodec/modbus/rtu/adu.hpp>

#ifdef OK
constexpr auto no = modbus::rtu::encode(247, cmd.write(cia402::command::shutdown));
#else
constexpr auto no = modbus::rtu::encode(248, cmd.write(cia402::command::shutdown));
#endif
