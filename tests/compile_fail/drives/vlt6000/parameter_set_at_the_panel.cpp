// EXPECT: this_register_or_parameter_is_set_at_the_panel_and_not_over_the_bus
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;

#ifdef OK
constexpr auto request = vlt6000::parameter<501>.read(fc::data_not_valid);
#else
constexpr auto request = vlt6000::parameter<501>.write(5, fc::storage::ram, fc::data_not_valid);
#endif
