// EXPECT: parameter_number_must_be_between_0_and.*2047
#include <drivecodec/fc/parameter_requests.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto asked = read_value<fc_layout>(2048, data_not_valid);
#else
constexpr auto asked = read_value(2048, data_not_valid);
#endif
