// EXPECT: the_smd_reads_one_register_or_6_at_24_or_4_at_c99
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = smd::read_input_registers::request{.range = {24, 6}};
#else
constexpr auto no = smd::read_input_registers::request{.range = {25, 6}};
#endif
