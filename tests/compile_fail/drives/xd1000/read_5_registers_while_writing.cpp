// EXPECT: register_count_must_be_between.*(Min = 1; int Max = 4|<1, 4>)
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr auto no = read_write_multiple_registers::of({12741, 4}, 12761, {1});
#else
constexpr auto no = read_write_multiple_registers::of({12741, 5}, 12761, {1});
#endif
