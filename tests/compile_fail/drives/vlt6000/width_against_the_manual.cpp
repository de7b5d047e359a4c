// EXPECT: the manual states another width of this parameter
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto given = vlt6000::parameter<202>.as<fc::data_type::unsigned_16>;
#else
constexpr auto given = vlt6000::parameter<202>.as<fc::data_type::unsigned_32>;
#endif
constexpr auto request = given.write(10_Hz, fc::storage::ram, fc::data_not_valid);
