// The instructions that it takes to decode the smd drive's status block, from the wire to its fields.
#include <drivecodec/drives/smd/status_block.hpp>

using drivecodec::bytes;
namespace smd = drivecodec::smd;

#define MEASURED extern "C" [[gnu::noinline]]

constexpr std::array<std::uint8_t, 12> reply{0x02, 0x01, 0x01, 0x9C, 0x64, 0x06, 0x00, 0x0B, 0x06, 0x00, 0x00, 0x01};

/// What a master does with the values of a response. False if they are refused.
MEASURED bool measured_decode_status_block(bytes wire, smd::status_block& to)
{
    auto const status = smd::status_block::decode(drivecodec::modbus::register_view::of_wire(wire));
    if (status) { to = *status; }
    return status.has_value();
}

int main()
{
    bytes wire{reply};
    asm volatile("" : "+m"(wire) : : "memory");  // read anew: the compiler must not know what is in it
    static smd::status_block status{};
    return measured_decode_status_block(wire, status) and status.actual_speed.number == 412 ? 0 : 1;
}
