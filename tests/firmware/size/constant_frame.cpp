#include "constant_frame.hpp"

#include <drivecodec/modbus.hpp>

using namespace drivecodec::modbus;

constexpr auto frame = rtu::encode(7, read_holding_registers::request{{0x006B, 3}});

void send()
{
    transmit(frame.data(), frame.size());
}
