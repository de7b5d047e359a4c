// EXPECT: the_digits_of_a_quantity_are_at_most_2147483647_and_128_after_the_point
#include <drivecodec/core/quantity.hpp>

using namespace drivecodec::literals;

#ifdef OK
constexpr auto limit = 2147483647_Hz;
#else
constexpr auto limit = 2147483648_Hz;
#endif
