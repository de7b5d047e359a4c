// EXPECT: the_parameter_has_another_unit_or_one_that_is_to_be_said_in_its_as
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto given = vlt6000::parameter<207>.as<fc::data_type::unsigned_16, 0, unit::second>;
#else
constexpr auto given = vlt6000::parameter<207>.as<fc::data_type::unsigned_16, 0>;
#endif
constexpr auto request = given.write(5_s, fc::storage::ram, fc::data_not_valid);
