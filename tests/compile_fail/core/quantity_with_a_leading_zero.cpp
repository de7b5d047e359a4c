// EXPECT: a_quantity_is_written_without_leading_zeros_which_would_mean_octal
#include <drivecodec/core/quantity.hpp>

using namespace drivecodec::literals;

#ifdef OK
constexpr auto limit = 10_Hz;
#else
constexpr auto limit = 010_Hz;
#endif
