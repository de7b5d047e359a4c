// EXPECT: deleted
#include <drivecodec/modbus/functions/read_registers.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr std::array<std::uint8_t, 4> pdu{3, 2, 0, 1};
constexpr auto                        given = drivecodec::decode<read_holding_registers::response>(pdu);
#else
constexpr auto given = drivecodec::decode<read_holding_registers::response>(std::array<std::uint8_t, 4>{3, 2, 0, 1});
#endif
