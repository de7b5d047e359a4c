// EXPECT: cannot convert|no matching|no viable|could not convert|no known conversion
#include <drivecodec/cia402.hpp>

using namespace drivecodec::cia402;

#ifdef OK
constexpr bool no = status_word{}.test(status_word::remote);
#else
constexpr bool no = status_word{}.test(control_word::halt);
#endif
