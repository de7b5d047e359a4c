#include "constant_frame.hpp"

#include <drivecodec/modbus/rtu/adu.hpp>
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;

constexpr auto frame = modbus::rtu::encode(2, xd1000::cmd.write(cia402::command::enable_operation));

void send()
{
    transmit(frame.data(), frame.size());
}
