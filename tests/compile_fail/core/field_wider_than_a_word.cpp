// EXPECT: field does not fit in a word
#include <drivecodec/core/word.hpp>

using namespace drivecodec;

#ifdef OK
constexpr field<struct status, int, 16, 16> high{};
#else
constexpr field<struct status, int, 17, 16> high{};
#endif
