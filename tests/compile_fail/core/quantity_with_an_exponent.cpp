// EXPECT: a_quantity_is_written_as_decimal_digits_with_at_most_one_point
#include <drivecodec/core/quantity.hpp>

using namespace drivecodec::literals;

#ifdef OK
constexpr auto limit = 1'000_Hz;
#else
constexpr auto limit = 1e3_Hz;
#endif
