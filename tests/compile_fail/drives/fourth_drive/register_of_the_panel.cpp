// EXPECT: this_register_or_parameter_is_set_at_the_panel_and_not_over_the_bus
#include "drives/fourth_drive/pump.hpp"

using namespace drivecodec::literals;

#ifdef OK
constexpr auto no = pump::reserve_of_the_panel.read();
#else
constexpr auto no = pump::reserve_of_the_panel.write(0);
#endif
