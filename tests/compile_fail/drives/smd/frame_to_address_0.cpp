// EXPECT: address_0_is_the_broadcast_write_rtu_broadcast
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = rtu::encode(1, smd::drive_control.write(smd::command::stop));
#else
constexpr auto no = rtu::encode(0, smd::drive_control.write(smd::command::stop));
#endif
