// EXPECT: this_diagnostic_does_not_allow_this_data
#include <drivecodec/modbus/functions/diagnostics.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr auto asked = diagnostics::of(diagnostic::return_bus_message_count);
#else
constexpr auto asked = diagnostics::of(diagnostic::return_bus_message_count, {0, 0});
#endif
