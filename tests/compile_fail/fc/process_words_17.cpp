// EXPECT: PCD has 2 to 16 words
#include <drivecodec/fc/data_layout.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto size = data_layout<16>::process_size;
#else
constexpr auto size = data_layout<17>::process_size;
#endif
