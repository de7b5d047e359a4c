// EXPECT: this version of the smd does not have this parameter
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = smd::C31<smd::pv507>.read();
#else
constexpr auto no = smd::C31<smd::pv400>.read();
#endif
