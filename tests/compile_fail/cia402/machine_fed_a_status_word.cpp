// EXPECT: cannot convert|no matching|no viable|could not convert|no known conversion
#include <drivecodec/cia402.hpp>

using namespace drivecodec::cia402;

#ifdef OK
constexpr auto no = [](machine drive) { drive.receive(control_word{}); };
#else
constexpr auto no = [](machine drive) { drive.receive(status_word{}); };
#endif
