// EXPECT: register_count_must_be_between.*1.*121
#include <drivecodec/modbus/functions/read_write_multiple_registers.hpp>

using namespace drivecodec::modbus;

template <std::size_t N>
constexpr std::uint16_t words[N]{};

#ifdef OK
constexpr auto asked = read_write_multiple_registers::of({0, 1}, 0, words<121>);
#else
constexpr auto asked = read_write_multiple_registers::of({0, 1}, 0, words<122>);
#endif
