// EXPECT: the VLT 6000 manual names no parameter of this number
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;

#ifdef OK
constexpr auto request = vlt6000::parameter<202>.read(fc::data_not_valid);
#else
constexpr auto request = vlt6000::parameter<0x10000 + 202>.read(fc::data_not_valid);
#endif
