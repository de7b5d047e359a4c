// EXPECT: the_value_has_more_digits_than_the_register_or_parameter_can_hold
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = smd::serial_speed_command.write(41.2_Hz);
#else
constexpr auto no = smd::serial_speed_command.write(41.25_Hz);
#endif
