// EXPECT: the manual does not state how this parameter is transferred: say it
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto interval = vlt6000::parameter<555>.as<fc::data_type::unsigned_16, 0>;
#else
constexpr auto interval = vlt6000::parameter<555>;
#endif
constexpr auto request = interval.write(10_s, fc::storage::ram, fc::data_not_valid);
