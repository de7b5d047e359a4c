// EXPECT: modbus_registers_are_numbered_from_1_to_256
#include <drivecodec/drives/smd/numbering.hpp>

using namespace drivecodec::smd;

#ifdef OK
constexpr auto no = register_number::from_modbus(1);
#else
constexpr auto no = register_number::from_modbus(0);
#endif
