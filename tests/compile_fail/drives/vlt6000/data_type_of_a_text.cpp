// EXPECT: only integer_16 to unsigned_32 are transferred as a number
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto given = vlt6000::parameter<505>.as<fc::data_type::unsigned_8>;
#else
constexpr auto given = vlt6000::parameter<505>.as<fc::data_type::text_string>;
#endif
constexpr auto request = given.write(vlt6000::gating::logic_and, fc::storage::ram, fc::data_not_valid);
