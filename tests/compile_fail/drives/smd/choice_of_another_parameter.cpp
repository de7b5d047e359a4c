// EXPECT: operating_mode
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = smd::C14<smd::pv400>.write(smd::operating_mode::linear_with_auto_boost);
#else
constexpr auto no = smd::C14<smd::pv400>.write(smd::chopper_frequency::chopper_4_khz);
#endif
