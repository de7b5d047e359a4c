// EXPECT: coil_count_must_be_between.*1.*1968
#include <drivecodec/modbus/functions/write_multiple_coils.hpp>

using namespace drivecodec::modbus;

template <std::size_t N>
constexpr bool states[N]{};

#ifdef OK
constexpr auto written = write_multiple_coils::of(0, states<1968>);
#else
constexpr auto written = write_multiple_coils::of(0, states<1969>);
#endif
