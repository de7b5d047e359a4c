// Any set-up of the communication scanner, any values to exchange, any answer: what the drive forbids is refused, and a
// value is told only of a register that is mapped and was answered.
//
// Input: eight addresses (2 bytes each), the number of values (1), the values, the answer.
#include "fuzz_common.hpp"
#include "input.hpp"

#include <drivecodec/xd1000.hpp>

using namespace drivecodec;

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input                               input{data, size};
    xd1000::scanner_configuration::addresses inputs{};
    xd1000::scanner_configuration::addresses outputs{};
    for (auto& each : inputs) { each = input.u16(); }
    for (auto& each : outputs) { each = input.u16(); }

    auto is_allowed = true;
    for (auto const each : inputs) { is_allowed = is_allowed and (each == 0 or xd1000::find(each) != nullptr); }
    for (auto const each : outputs) {
        auto const* row = xd1000::find(each);
        is_allowed      = is_allowed and (each == 0 or (row != nullptr and row->is_writable()));
    }
    auto const made = xd1000::scanner_configuration::make(inputs, outputs);
    FUZZ_ASSERT(made.has_value() == is_allowed);
    auto const scanner = made.value_or({});
    if (made) { FUZZ_ASSERT(made->inputs() == inputs and made->outputs() == outputs); }

    std::size_t const                count = input.u8() % 8;
    exact_array<std::uint16_t> const values{count};
    for (auto& each : values.get()) { each = input.u16(); }
    std::size_t used = 4;
    while (used > 0 and scanner.inputs()[used - 1] == 0) { --used; }
    auto const asked = scanner.exchange(values.get());
    FUZZ_ASSERT(asked.has_value() == (count >= 1 and count <= 4 and used >= 1));
    if (asked) {
        FUZZ_ASSERT(asked->read_range.first() == 12741 and asked->read_range.count() == used);
        FUZZ_ASSERT(asked->write_block.first() == 12761 and asked->write_block.count() == count);
    }

    auto const   rest = input.rest();
    exact_buffer answer{rest.size()};
    copy_bytes(rest, answer.get());
    auto const given = modbus::register_view::of_wire(bytes{answer.get()});
    for (auto const address : {inputs[0], inputs[1], inputs[2], inputs[3], outputs[0], outputs[1], std::uint16_t{0}}) {
        std::size_t word = 0;
        while (word < 4 and (scanner.inputs()[word] != address or address == 0)) { ++word; }
        auto const found = scanner.input(address, given);
        FUZZ_ASSERT(found.has_value() == (word < 4 and word < given.size()));
        if (found) { FUZZ_ASSERT(*found == given[word]); }
    }
    return 0;
}
