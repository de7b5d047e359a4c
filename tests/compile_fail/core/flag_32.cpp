// EXPECT: flag_is_outside_the_word
#include <drivecodec/core/word.hpp>

using namespace drivecodec;

#ifdef OK
constexpr flag<struct status> top{31};
#else
constexpr flag<struct status> top{32};
#endif
