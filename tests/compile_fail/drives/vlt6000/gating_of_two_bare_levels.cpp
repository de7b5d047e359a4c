// EXPECT: too many arguments|no matching function|could not convert
#include <drivecodec/drives/vlt6000/gating.hpp>

using namespace drivecodec::vlt6000;

#ifdef OK
constexpr bool coasts = is_coasting(gating::logic_or, {.terminal = true, .bus = false});
#else
constexpr bool coasts = is_coasting(gating::logic_or, true, false);
#endif
