// EXPECT: this_register_or_parameter_is_read_only
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto request = vlt6000::parameter<512>.read(fc::data_not_valid);
#else
constexpr auto request = vlt6000::parameter<512>.write(5_Hz, fc::storage::ram, fc::data_not_valid);
#endif
