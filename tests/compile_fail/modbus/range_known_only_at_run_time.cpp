// EXPECT: not a constant expression|consteval function .*is not a constant
#include <drivecodec/modbus/address_range.hpp>

using namespace drivecodec::modbus;

#ifdef OK
auto range_of(std::uint16_t first) { return register_range<125>::make(first, 2); }
#else
auto range_of(std::uint16_t first) { return register_range<125>{first, 2}; }
#endif
