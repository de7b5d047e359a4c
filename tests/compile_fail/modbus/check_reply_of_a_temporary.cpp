// EXPECT: deleted function
#include <drivecodec/modbus.hpp>

#include <array>

using namespace drivecodec;
using namespace drivecodec::modbus;

std::array<std::uint8_t, 4>               received();
constexpr read_holding_registers::request asked{{0, 1}};

#ifdef OK
bool answered()
{
    auto const pdu = received();
    return check_reply(asked, pdu).has_value();
}
#else
bool answered()
{
    return check_reply(asked, received()).has_value();
}
#endif
