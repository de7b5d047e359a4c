// Any PDU and any frame as words, in any room: the whole text or its beginning, printable, never a character outside.
//
// Input: direction and alignment, the room (2 bytes), the size of the request heard before, that request, the PDU.
#include "fuzz_common.hpp"
#include "input.hpp"
#include "modbus/rules.hpp"
#include "text/description.hpp"

#include <drivecodec/text/modbus.hpp>

namespace {

namespace modbus = drivecodec::modbus;
using drivecodec::bytes;
using modbus::direction;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input  input{data, size};
    auto const  flags   = input.u8();
    auto const  which   = flags % 2 == 0 ? direction::request : direction::response;
    auto const  room    = input.u16();
    bytes const request = input.take(input.u8());
    bytes const pdu     = input.rest();

    check_description(modbus::max_description_size, room,
                      [&](std::span<char> out) { return modbus::describe(which, pdu, out, request); });

    drivecodec::text_writer nowhere;
    auto const              fault = modbus::write_message(nowhere, which, pdu, request);
    FUZZ_ASSERT(fault.ok() == (which == direction::request ? rules::is_request(pdu) : rules::is_response(pdu)));
    FUZZ_ASSERT(nowhere.view().empty() and nowhere.needed() > 0);

    if (pdu.size() < 4) { return 0; }  // as a frame, with whatever CRC
    modbus::rtu::frame const frame{.raw = pdu, .direction = which, .aligned = flags / 2 % 2 != 0};
    check_description(modbus::max_description_size, room,
                      [&](std::span<char> out) { return modbus::rtu::describe(frame, out, request); });
    return 0;
}
