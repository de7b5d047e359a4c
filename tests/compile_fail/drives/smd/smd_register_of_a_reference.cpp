// EXPECT: smd_registers_are_numbered_from_0_to_255
#include <drivecodec/drives/smd/numbering.hpp>

using namespace drivecodec::smd;

#ifdef OK
constexpr auto no = register_number::from_smd(24);
#else
constexpr auto no = register_number::from_smd(40025);
#endif
