// EXPECT: is not a constant expression|must be initialized by a constant expression|accessing .*value_
#include <drivecodec/cia402.hpp>

using namespace drivecodec::cia402;

#ifdef OK
constexpr auto no = *path::between(state::operation_enabled, state::quick_stop_active);
#else
constexpr auto no = *path::between(state::operation_enabled, state::fault);
#endif
