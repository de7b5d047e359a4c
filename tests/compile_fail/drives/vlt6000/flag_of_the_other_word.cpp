// EXPECT: cannot convert|no matching|no viable|could not convert|no known conversion
#include <drivecodec/drives/vlt6000/control_word.hpp>
#include <drivecodec/drives/vlt6000/status_word.hpp>

using namespace drivecodec::vlt6000;

#ifdef OK
constexpr bool no = status_word{}.test(status_word::running);
#else
constexpr bool no = status_word{}.test(control_word::start);
#endif
