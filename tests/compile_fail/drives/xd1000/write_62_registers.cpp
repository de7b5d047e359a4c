// EXPECT: register_count_must_be_between.*(Min = 1; int Max = 61|<1, 61>)
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr std::uint16_t words[61]{};
constexpr auto          no = write_multiple_registers::of(12701, words);
#else
constexpr std::uint16_t words[62]{};
constexpr auto          no = write_multiple_registers::of(12701, words);
#endif
