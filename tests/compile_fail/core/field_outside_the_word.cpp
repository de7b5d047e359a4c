// EXPECT: the field is outside the word
#include <drivecodec/core/word.hpp>

using namespace drivecodec;

struct small : word<small, std::uint8_t> {};

#ifdef OK
static_assert(small{}.get(field<small, int, 6, 2>{}) == 0);
#else
static_assert(small{}.get(field<small, int, 6, 8>{}) == 0);
#endif
