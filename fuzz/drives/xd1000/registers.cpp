// Reads and writes of any registers with any values: what the drive's table forbids is refused, and nothing else is; what
// is allowed goes to the wire and comes back.
//
// Input: the first address (2 bytes), a count (1), then values of two bytes.
#include "fuzz_common.hpp"
#include "input.hpp"

#include <drivecodec/modbus/rtu/adu.hpp>
#include <drivecodec/text/xd1000.hpp>

#include <vector>

using namespace drivecodec;

namespace {

/// The registers of the manual, once more.
bool exists(unsigned address)
{
    auto const between = [&](unsigned first, unsigned last) { return address >= first and address <= last; };
    return between(3102, 3105) or address == 3201 or address == 3206 or address == 6001 or between(6003, 6005)
           or address == 8501 or address == 8504 or address == 8602 or address == 8604 or address == 9001
           or between(12701, 12704) or between(12721, 12724) or between(12741, 12744) or between(12761, 12764);
}

bool takes(unsigned address, unsigned value)
{
    switch (address) {
    case 3201:
    case 3206:
    case 8604:
    case 12741:
    case 12742:
    case 12743:
    case 12744: return false;
    case 6001: return value <= 247;
    case 6003: return value == 24 or value == 28 or value == 32 or value == 36;
    case 6004: return value >= 2 and value <= 5;
    case 6005: return value >= 1 and value <= 300;
    default: return true;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input input{data, size};
    auto const first = input.u16();
    auto const count = std::uint16_t{input.u8()};

    auto all_exist = true;
    for (unsigned i = 0; i < count; ++i) { all_exist = all_exist and exists(first + i); }
    auto const read = xd1000::make_read(first, count);
    FUZZ_ASSERT(read.has_value() == (count >= 1 and count <= 63 and all_exist));
    if (read) { FUZZ_ASSERT(*decode<xd1000::read_holding_registers::request>(encode(*read)) == *read); }

    std::vector<std::uint16_t> values;
    while (not input.empty()) { values.push_back(input.u16()); }
    auto is_allowed = values.size() >= 1 and values.size() <= 61;
    for (std::size_t i = 0; i < values.size(); ++i) {
        is_allowed = is_allowed and exists(static_cast<unsigned>(first + i))
                     and takes(static_cast<unsigned>(first + i), values[i]);
    }
    auto const write = xd1000::make_write(first, values);
    FUZZ_ASSERT(write.has_value() == is_allowed);
    if (write) {
        exact_buffer pdu{write->wire_size()};
        write->write(pdu.get());
        FUZZ_ASSERT(*decode<xd1000::write_multiple_registers::request>(bytes{pdu.get()}) == *write);
    }

    // Words for anything.
    exact_array<char> text{values.size() * 4};
    text_writer       out{text.get()};
    write_text(out, xd1000::register_values{first, values});
    FUZZ_ASSERT(out.view().size() <= text.get().size());
    return 0;
}
