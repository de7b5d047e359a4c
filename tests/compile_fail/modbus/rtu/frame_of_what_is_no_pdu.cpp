// EXPECT: framable
#include <drivecodec/modbus.hpp>

#include <array>

using namespace drivecodec;
using namespace drivecodec::modbus;

#ifdef OK
constexpr auto frame = rtu::encode(1, write_single_register::request{1, 2});
#else
constexpr auto frame = rtu::encode(1, register_array<2>{{1, 2}});
#endif
