// The instructions of what messages.cpp measures by the clock.

#include "modbus/rtu/messages.hpp"

#include <drivecodec/modbus/crc16/byte_table.hpp>

namespace crc16 = drivecodec::modbus::crc16;
using drivecodec::bytes;
using drivecodec::mutable_bytes;

#define MEASURED extern "C" [[gnu::noinline]]

MEASURED std::uint32_t measured_decode_request_03(bytes wire)
{
    return messages::decode_request_03(wire);
}

MEASURED std::size_t measured_decode_response_03(bytes wire, std::array<std::uint16_t, 125>& to)
{
    return messages::decode_response_03(wire, to);
}

MEASURED std::size_t measured_encode_request_16(std::span<std::uint16_t const> words, mutable_bytes out)
{
    return messages::encode_request_16(words, out);
}

MEASURED std::uint16_t measured_crc_of_255_bytes(bytes wire)
{
    return crc16::compute(wire);
}

MEASURED std::uint16_t measured_crc_of_255_bytes_byte_table(bytes wire)
{
    return crc16::compute<crc16::byte_table>(wire);
}

int main()
{
    // Read anew each time: the compiler must not know what is in the frames.
    auto const opaque = [](auto const& known) {
        bytes value{known};
        asm volatile("" : "+m"(value) : : "memory");
        return value;
    };
    static std::array<std::uint16_t, 125>                        values{};
    static std::array<std::uint8_t, messages::rtu::max_adu_size> out{};

    bool worked = measured_decode_request_03(opaque(messages::request_03)) != 0;
    worked      = measured_decode_response_03(opaque(messages::response_03), values) == values.size() and worked;
    worked      = values == messages::words_125 and worked;
    worked      = measured_encode_request_16(messages::words_123, out) == messages::request_16_size and worked;
    worked      = measured_crc_of_255_bytes(opaque(messages::response_03)) == crc16::residue and worked;
    worked      = measured_crc_of_255_bytes_byte_table(opaque(messages::response_03)) == crc16::residue and worked;
    return worked ? 0 : 1;
}
