// EXPECT: cannot convert|no matching|no viable|could not convert|no known conversion
#include <drivecodec/cia402.hpp>

using namespace drivecodec::cia402;

#ifdef OK
constexpr auto no = apply(command::shutdown, control_word{});
#else
constexpr auto no = apply(command::shutdown, status_word{});
#endif
