// EXPECT: this_register_or_parameter_is_read_only
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = smd::serial_speed_command.write(50.0_Hz);
#else
constexpr auto no = smd::command_speed.write(50.0_Hz);
#endif
