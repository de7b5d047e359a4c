// EXPECT: not a constant expression|is not usable in a constant expression
#include <drivecodec/modbus/rtu/address.hpp>

using namespace drivecodec::modbus;

bool is_broadcast(int address)
{
#ifdef OK
    auto const made = rtu::server_address::make(static_cast<unsigned char>(address));
    return made and made->is_broadcast();
#else
    rtu::server_address const made = address;
    return made.is_broadcast();
#endif
}
