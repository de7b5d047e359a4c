// EXPECT: parameter_number_must_be_between_0_and.*4095
#include <drivecodec/fc/parameter_requests.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto asked = read_value<fc_layout>(4095, data_not_valid);
#else
constexpr auto asked = read_value<fc_layout>(4096, data_not_valid);
#endif
