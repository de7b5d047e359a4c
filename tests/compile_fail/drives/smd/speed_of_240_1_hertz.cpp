// EXPECT: the_value_must_be_between_min_and_max_times_ten_to_the_exponent
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = smd::serial_speed_command.write(240.0_Hz);
#else
constexpr auto no = smd::serial_speed_command.write(240.1_Hz);
#endif
