// Any PDU and any frame as words, in any room: the whole text or its beginning, printable, never a character outside.
//
// Input: direction and alignment, the room (2 bytes), the size of the request heard before, that request, the PDU.
#include "fuzz_common.hpp"
#include "input.hpp"
#include "modbus/rules.hpp"

#include <drivecodec/text/modbus.hpp>

#include <string_view>

namespace {

namespace modbus = drivecodec::modbus;
using drivecodec::bytes;
using modbus::direction;

using characters = exact_array<char>;

/// `describe(room)` in plenty of room, and in `room` characters.
template <typename Describe>
void check(std::size_t room, Describe describe)
{
    characters const       plenty{modbus::max_description_size};
    std::string_view const whole = describe(plenty.get());
    FUZZ_ASSERT(not whole.empty() and whole.size() < modbus::max_description_size and whole.data() == plenty.get().data());
    for (auto const character : whole) { FUZZ_ASSERT(character >= ' ' and character <= '~'); }
    FUZZ_ASSERT(whole.back() != ' ');

    characters const       narrow{room % (whole.size() + 2)};
    std::string_view const part = describe(narrow.get());
    auto const             size = narrow.get().size();
    if (size >= whole.size()) {
        FUZZ_ASSERT(part == whole);
        return;
    }
    auto const dots = size < 3 ? size : 3;
    FUZZ_ASSERT(part.size() == size);
    FUZZ_ASSERT(part.substr(0, size - dots) == whole.substr(0, size - dots));
    FUZZ_ASSERT(part.substr(size - dots) == std::string_view{"..."}.substr(0, dots));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input  input{data, size};
    auto const  flags   = input.u8();
    auto const  which   = flags % 2 == 0 ? direction::request : direction::response;
    auto const  room    = input.u16();
    bytes const request = input.take(input.u8());
    bytes const pdu     = input.rest();

    check(room, [&](std::span<char> out) { return modbus::describe(which, pdu, out, request); });

    drivecodec::text_writer nowhere;
    auto const              fault = modbus::write_message(nowhere, which, pdu, request);
    FUZZ_ASSERT(fault.ok() == (which == direction::request ? rules::is_request(pdu) : rules::is_response(pdu)));
    FUZZ_ASSERT(nowhere.view().empty() and nowhere.needed() > 0);

    if (pdu.size() < 4) { return 0; }  // as a frame, with whatever CRC
    modbus::rtu::frame const frame{.raw = pdu, .direction = which, .aligned = flags / 2 % 2 != 0};
    check(room, [&](std::span<char> out) { return modbus::rtu::describe(frame, out, request); });
    return 0;
}
