// EXPECT: cannot convert|no matching|no viable|could not convert|no known conversion
#include <drivecodec/cia402.hpp>

using namespace drivecodec::cia402;

#ifdef OK
constexpr auto no = controller{}.update(status_word{});
#else
constexpr auto no = controller{}.update(control_word{});
#endif
