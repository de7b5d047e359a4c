// EXPECT: the manual does not state the conversion index: say it
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto given = vlt6000::parameter<555>.as<fc::data_type::unsigned_16, 0>;
#else
constexpr auto given = vlt6000::parameter<555>.as<fc::data_type::unsigned_16>;
#endif
constexpr auto request = given.write(5_s, fc::storage::ram, fc::data_not_valid);
