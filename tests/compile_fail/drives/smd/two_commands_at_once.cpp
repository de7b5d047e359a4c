// EXPECT: the_value_is_none_of_those_that_the_register_or_parameter_takes
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = smd::drive_control.write(smd::command{0x0008});
#else
constexpr auto no = smd::drive_control.write(smd::command{0x0088});
#endif
