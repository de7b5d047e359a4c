// EXPECT: deleted function
#include <drivecodec/modbus/functions.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

#include <vector>

using namespace drivecodec::modbus;

std::vector<std::uint8_t> receive();

auto first_value()
{
#ifdef OK
    auto const received = receive();
    auto const response = rtu::decode<read_holding_registers::response>(received);
#else
    auto const response = rtu::decode<read_holding_registers::response>(receive());
#endif
    return response->message.values[0];
}
