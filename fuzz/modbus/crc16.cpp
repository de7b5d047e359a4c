// All ways to compute the CRC are one: at any alignment, from any remainder, split anywhere.
#include "fuzz_common.hpp"
#include "input.hpp"
#include "repair_crc16.hpp"

#include <drivecodec/modbus/crc16.hpp>
#include <drivecodec/modbus/crc16/byte_table.hpp>
#include <drivecodec/modbus/crc16/carryless.hpp>
#include <drivecodec/modbus/crc16/nibble.hpp>

namespace {

namespace crc16 = drivecodec::modbus::crc16;
using drivecodec::bytes;

template <crc16::algorithm Algorithm>
void check(bytes message, std::uint16_t begin, std::size_t split)
{
    FUZZ_ASSERT(crc16::compute<Algorithm>(message) == reference_crc16(message));
    auto const whole = Algorithm::update(begin, message);
    FUZZ_ASSERT(whole == crc16::bitwise::update(begin, message));
    FUZZ_ASSERT(whole == Algorithm::update(Algorithm::update(begin, message.first(split)), message.subspan(split)));
    FUZZ_ASSERT(Algorithm::update(begin, {}) == begin);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input input{data, size};
    auto const begin     = input.u16();
    auto const alignment = input.below(16);
    auto const split     = input.u16();
    auto const message   = input.rest();

    exact_buffer const block{alignment + message.size()};
    auto const         aligned = block.get().subspan(alignment);
    drivecodec::copy_bytes(message, aligned);
    auto const at = split % (message.size() + 1);

    check<crc16::bitwise>(aligned, begin, at);
    check<crc16::nibble>(aligned, begin, at);
    check<crc16::byte_table>(aligned, begin, at);
    check<crc16::slices>(aligned, begin, at);
    check<crc16::carryless>(aligned, begin, at);
    return 0;
}
