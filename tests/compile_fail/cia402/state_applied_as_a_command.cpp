// EXPECT: cannot convert|no matching|no viable|could not convert|no known conversion
#include <drivecodec/cia402.hpp>

using namespace drivecodec::cia402;

#ifdef OK
constexpr auto no = apply(command::switch_on, control_word{});
#else
constexpr auto no = apply(state::switched_on, control_word{});
#endif
