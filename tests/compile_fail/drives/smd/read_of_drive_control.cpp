// EXPECT: this_register_or_parameter_is_write_only
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = smd::command_speed.read();
#else
constexpr auto no = smd::drive_control.read();
#endif
