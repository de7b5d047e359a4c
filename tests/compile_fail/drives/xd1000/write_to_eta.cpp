// EXPECT: this_register_or_parameter_is_read_only
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr auto no = cmd.write(command_word::from_raw(0));
#else
constexpr auto no = eta.write(status_word::from_raw(0));
#endif
