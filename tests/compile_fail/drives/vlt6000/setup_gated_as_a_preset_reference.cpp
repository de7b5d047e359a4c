// EXPECT: cannot convert|could not convert|no matching|no viable|cannot initialize
#include <drivecodec/drives/vlt6000/gating.hpp>

using namespace drivecodec::vlt6000;

#ifdef OK
constexpr auto active = active_setup(gating::logic_or, {.terminal = setup::setup_1, .bus = setup::setup_2});
#else
constexpr auto active =
    active_setup(gating::logic_or, {.terminal = setup::setup_1, .bus = preset_reference::preset_reference_2});
#endif
