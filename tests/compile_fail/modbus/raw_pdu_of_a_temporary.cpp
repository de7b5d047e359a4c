// EXPECT: deleted function
#include <drivecodec/modbus.hpp>

#include <array>

using namespace drivecodec;
using namespace drivecodec::modbus;

std::array<std::uint8_t, 4> received();

#ifdef OK
std::size_t passed_on()
{
    auto const pdu = received();
    return raw_pdu::make(pdu)->wire_size();
}
#else
std::size_t passed_on()
{
    return raw_pdu::make(received())->wire_size();
}
#endif
