// EXPECT: parameter numbers have 11 or 12 bits
#include <drivecodec/fc/data_layout.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto size = data_layout<2, 12>::process_size;
#else
constexpr auto size = data_layout<2, 10>::process_size;
#endif
