// EXPECT: the smd manual has no parameter of this code; codes are case sensitive
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
namespace rtu = modbus::rtu;

#ifdef OK
constexpr auto no = smd::parameter<"C90", smd::pv507>.read();
#else
constexpr auto no = smd::parameter<"c90", smd::pv507>.read();
#endif
