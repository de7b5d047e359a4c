// EXPECT: cannot convert|no matching|no viable|could not convert|no known conversion
#include <drivecodec/cia402.hpp>

using namespace drivecodec::cia402;

#ifdef OK
constexpr auto no = decode_state(status_word::from_raw(0x0637));
#else
constexpr auto no = decode_state(0x0637);
#endif
