// EXPECT: this conversion index is no power of ten
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto given = vlt6000::parameter<207>.as<fc::data_type::unsigned_16, 0, unit::second>;
#else
constexpr auto given = vlt6000::parameter<207>.as<fc::data_type::unsigned_16, 74, unit::second>;
#endif
constexpr auto request = given.write(36_s, fc::storage::ram, fc::data_not_valid);
