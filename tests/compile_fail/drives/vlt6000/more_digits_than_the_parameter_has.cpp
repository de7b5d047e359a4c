// EXPECT: the_value_has_more_digits_than_the_register_or_parameter_can_hold
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto wanted = 50.1_Hz;
#else
constexpr auto wanted = 50.05_Hz;  // parameter 202 has tenths
#endif
constexpr auto request = vlt6000::parameter<202>.write(wanted, fc::storage::ram, fc::data_not_valid);
