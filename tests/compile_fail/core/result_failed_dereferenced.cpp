// EXPECT: value_.* member|inactive|which is not active
#include <drivecodec/core/result.hpp>

using namespace drivecodec;

constexpr result<int> half(int of)
{
    if (of % 2 != 0) { return error{errc::bad_value, 0}; }
    return of / 2;
}

#ifdef OK
static_assert(*half(4) == 2);
#else
static_assert(*half(3) == 1);
#endif
