// EXPECT: register_count_must_be_between
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = smd::write_multiple_registers::of(40, {412});
#else
constexpr auto no = smd::write_multiple_registers::of(40, {412, 412});
#endif
