// EXPECT: deleted function
#include <drivecodec/modbus/functions.hpp>
#include <drivecodec/modbus/rtu/client.hpp>

#include <vector>

using namespace drivecodec::modbus;

std::vector<std::uint8_t> receive();

auto first_value(read_holding_registers::request const& asked)
{
#ifdef OK
    auto const received = receive();
    auto const reply    = rtu::check(1, asked, received);
#else
    auto const reply = rtu::check(1, asked, receive());
#endif
    return reply->values[0];
}
