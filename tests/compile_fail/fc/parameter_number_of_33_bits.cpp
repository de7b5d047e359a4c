// EXPECT: parameter_number_must_be_between_0_and.*2047
#include <drivecodec/fc/parameter_requests.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto asked = read_value(1, data_not_valid);
#else
constexpr auto asked = read_value(0x1'0000'0001, data_not_valid);
#endif
