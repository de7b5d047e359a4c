// EXPECT: is not a constant expression|must be initialized by a constant expression|accessing .*value_
#include <drivecodec/cia402.hpp>

using namespace drivecodec::cia402;

#ifdef OK
constexpr auto no = *decode_state(status_word::from_raw(0x0027));
#else
constexpr auto no = *decode_state(status_word::from_raw(0x0002));
#endif
