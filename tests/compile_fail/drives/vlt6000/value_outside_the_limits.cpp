// EXPECT: the_value_is_outside_the_limits_of_the_register_or_parameter
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto interval = 65534_s;
#else
constexpr auto interval = 65535_s;
#endif
constexpr auto request =
    vlt6000::parameter<555>.as<fc::data_type::unsigned_16, 0>.write(interval, fc::storage::ram, fc::data_not_valid);
