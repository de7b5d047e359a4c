// EXPECT: the_value_must_be_between_min_and_max_times_ten_to_the_exponent.*(Min = 1; int Max = 300|<1, 300, -1>)
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr auto no = time_out.write(30_s);
#else
constexpr auto no = time_out.write(31_s);
#endif
