#include <drivecodec/drivecodec.hpp>

namespace modbus = drivecodec::modbus;

// As a user would: a constant frame, and its decoding.
constexpr auto frame = modbus::rtu::encode(17, modbus::read_holding_registers::request{{0x006B, 3}});
static_assert(frame[6] == 0x76 and frame[7] == 0x87);

int main()
{
    auto const decoded = modbus::rtu::decode<modbus::read_holding_registers::request>(frame);
    return decoded and decoded->message.range.count() == 3 ? DRIVECODEC_VERSION_MAJOR : 1;
}
