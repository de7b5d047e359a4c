// EXPECT: cannot convert|no matching|no viable|could not convert|no known conversion
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr bool no = status_word{}.test(status_word::remote);
#else
constexpr bool no = status_word{}.test(command_word::halt);
#endif
