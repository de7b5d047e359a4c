// EXPECT: references_are_30001_to_30256_and_40001_to_40256
#include <drivecodec/drives/smd/numbering.hpp>

using namespace drivecodec::smd;

#ifdef OK
constexpr auto no = register_number::from_reference(40025);
#else
constexpr auto no = register_number::from_reference(400025);
#endif
