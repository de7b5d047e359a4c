// EXPECT: this_diagnostic_does_not_allow_this_data
#include <drivecodec/modbus/functions/diagnostics.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr auto asked = diagnostics::of(diagnostic::restart_communications_option, diagnostics::clear_log);
#else
constexpr auto asked = diagnostics::of(diagnostic::restart_communications_option, 1);
#endif
