// EXPECT: cannot convert|could not convert|no viable conversion|no matching|no known conversion
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr auto no = high_speed.write(50_Hz);
#else
constexpr auto no = high_speed.write(50_s);
#endif
