// EXPECT: register_count_must_be_between.*(Min = 1; int Max = 63|<1, 63>)
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr read_holding_registers::request no{{12701, 63}};
#else
constexpr read_holding_registers::request no{{12701, 64}};
#endif
