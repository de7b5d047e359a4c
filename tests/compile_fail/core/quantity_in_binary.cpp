// EXPECT: a_quantity_is_written_as_decimal_digits_with_at_most_one_point
#include <drivecodec/core/quantity.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr auto frequency = 2_Hz;
#else
constexpr auto frequency = 0b10_Hz;
#endif
