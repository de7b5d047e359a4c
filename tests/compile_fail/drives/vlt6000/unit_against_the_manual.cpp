// EXPECT: the manual states another unit of this parameter
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto given = vlt6000::parameter<206>.as<fc::data_type::unsigned_16, 0, unit::second>;
#else
constexpr auto given = vlt6000::parameter<206>.as<fc::data_type::unsigned_16, 0, unit::minute>;
#endif
constexpr auto request = given.write(5_s, fc::storage::ram, fc::data_not_valid);
