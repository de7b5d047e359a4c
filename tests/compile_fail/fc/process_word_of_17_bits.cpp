// EXPECT: no matching function
#include <drivecodec/fc/process.hpp>

using namespace drivecodec::fc;
using namespace drivecodec::literals;

#ifdef OK
constexpr std::uint16_t third = 0xFFFF;
#else
constexpr std::int32_t third = 0x1'0000;
#endif
constexpr auto command = data_valid<data_layout<3>>(0x047F, 50_percent, third);
