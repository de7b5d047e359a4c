// EXPECT: could not convert|cannot convert|no matching function|no viable conversion|no known conversion
#include <drivecodec/fc.hpp>
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;

#ifdef OK
constexpr auto process = fc::data_valid(vlt6000::control_word{}, {});
#else
constexpr auto process = fc::data_valid(vlt6000::status_word{}, {});
#endif
