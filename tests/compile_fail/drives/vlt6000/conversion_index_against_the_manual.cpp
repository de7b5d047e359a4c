// EXPECT: the manual states another conversion index of this parameter
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto given = vlt6000::parameter<201>.as<fc::data_type::unsigned_16, -1>;
#else
constexpr auto given = vlt6000::parameter<201>.as<fc::data_type::unsigned_16, 0>;
#endif
constexpr auto request = given.write(10_Hz, fc::storage::ram, fc::data_not_valid);
