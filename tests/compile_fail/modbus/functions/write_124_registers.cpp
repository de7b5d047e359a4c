// EXPECT: register_count_must_be_between.*1.*123
#include <drivecodec/modbus/functions/write_multiple_registers.hpp>

using namespace drivecodec::modbus;

template <std::size_t N>
constexpr std::uint16_t words[N]{};

#ifdef OK
constexpr auto written = write_multiple_registers::of(0, words<123>);
#else
constexpr auto written = write_multiple_registers::of(0, words<124>);
#endif
