// Registers of any address, code and value in both versions: what the table forbids is refused and nothing else, what is
// written comes back, and there are words for everything.
//
// Input: the number in register 50 (2 bytes), an address (2), a value (2), a count (1), then the characters of a code or
// name.
#include "fuzz_common.hpp"
#include "input.hpp"

#include <drivecodec/modbus/rtu/adu.hpp>
#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/smd/parameters.hpp>

#include <string>

using namespace drivecodec;

namespace {

/// By looking at every row.
drives::register_row const* row_at(smd::version which, std::uint16_t address)
{
    auto const in = [&](auto const& table) {
        drives::register_row const* found = nullptr;
        for (auto const& row : table) { found = row.address == address ? &row : found; }
        return found;
    };
    return which == smd::pv400 ? in(smd::table<smd::pv400>) : in(smd::table<smd::pv507>);
}

void write_and_read_back(smd::map drive, std::uint16_t address, std::uint16_t raw)
{
    auto const* row  = row_at(drive.version(), address);
    auto const  made = drive.make_write(address, raw);
    FUZZ_ASSERT(drive.find(address) == row);
    auto const is_one_of = [&] {
        auto found = row->choices.empty();
        for (auto const choice : row->choices) { found = found or choice == raw; }
        return found and raw >= row->limits.min and raw <= row->limits.max;
    };
    FUZZ_ASSERT(made.has_value() == (row != nullptr and row->is_writable() and is_one_of()));
    if (not made) { return; }
    FUZZ_ASSERT(*decode<smd::write_single_register::request>(encode(*made)) == *made);

    // The same as a physical value, by name.
    auto const again = drive.make_write(row->name, {row->number(raw), row->exponent});
    FUZZ_ASSERT(again and *again == *made);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input  input{data, size};
    auto const  register_50 = input.u16();
    auto const  address     = input.u16();
    auto const  raw         = input.u16();
    auto const  count       = std::uint16_t{input.u8()};
    std::string word;
    while (not input.empty()) { word += static_cast<char>(input.u8()); }

    auto const drive = smd::map::make(register_50);
    FUZZ_ASSERT(drive.has_value() == (register_50 == 400 or register_50 == 507));
    if (not drive) { return 0; }

    write_and_read_back(*drive, address, raw);
    if (auto const* row = drive->find(std::string_view{word})) {
        FUZZ_ASSERT(row->code == word or row->name == word);
        write_and_read_back(*drive, row->address, raw);
    }

    auto const* row      = row_at(drive->version(), address);
    auto const  may_read = row != nullptr and row->is_readable()
                          and (count == 1 or (address == 24 and count == 6) or (row->code == "C99" and count == 4));
    auto const read = drive->make_read(address, count);
    FUZZ_ASSERT(read.has_value() == may_read);
    if (read) { FUZZ_ASSERT(*decode<smd::read_holding_registers::request>(encode(*read)) == *read); }

    exact_array<char> room{count};
    text_writer       out{room.get()};
    write_text(out, smd::register_value{drive->version(), address, raw});
    FUZZ_ASSERT(out.view().size() <= room.get().size());
    return 0;
}
