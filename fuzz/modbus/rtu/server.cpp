// Any frame to a server that serves everything, with any room for the reply: no reply, or a valid one that the client's
// check takes as the reply to this request; never a byte outside the reply buffer.
//
// Input: own address, the handler's manner (6 bytes), the room (2 bytes), the frame.
#include "modbus/handler.hpp"
#include "modbus/message_oracle.hpp"
#include "modbus/mutate_pdu.hpp"

#include <drivecodec/modbus/rtu/client.hpp>
#include <drivecodec/modbus/rtu/server.hpp>

using namespace oracle;

namespace {

namespace rtu = modbus::rtu;

void check_reply(bytes request, bytes reply, full_handler const& handler)
{
    auto const asked = request.subspan(1, request.size() - 3);
    auto const given = reply.subspan(1, reply.size() - 3);
    FUZZ_ASSERT(reply.size() >= 4 and reply[0] == request[0] and has_reference_crc16(reply));
    FUZZ_ASSERT(rules::is_response(given));
    FUZZ_ASSERT((given[0] & 0x7F) == asked[0]);

    auto const own       = rtu::server_address::reserved(reply[0]);
    auto const is_served = modbus::public_functions::visit_request<bool>(asked, [&](auto const& decoded) {
        auto const taken = rtu::check(own, decoded, reply);
        if (taken) {
            FUZZ_ASSERT(rules::answers(asked, given));
        } else {
            FUZZ_ASSERT(taken.error().code() == errc::exception_reply);
            FUZZ_ASSERT(given[0] >= 0x80 and static_cast<std::uint8_t>(taken.error().exception()) == given[1]);
            if (handler.refuses()) { FUZZ_ASSERT(taken.error().exception() == handler.refusal()); }
        }
        return true;
    });
    if (not is_served) { FUZZ_ASSERT(given[0] >= 0x80 and given[1] >= 1 and given[1] <= 3); }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input   input{data, size};
    auto const   own = rtu::server_address::reserved(input.u8());
    fuzz_input   manner{input.take(6)};
    full_handler handler{manner};
    // Most rooms are as large as any reply.
    auto const         room = input.u16();
    exact_buffer const buffer{room % 4 == 0 ? room / 4 % 260U : 256U};
    bytes const        frame = input.rest();

    auto const reply = rtu::serve(own, frame, buffer.get(), handler);

    auto const is_intact = frame.size() >= 4 and frame.size() <= 256 and has_reference_crc16(frame);
    auto const is_own    = is_intact and own.byte() == frame[0] and own.byte() != 0;
    auto const is_heard  = is_own or (is_intact and frame[0] == 0);
    auto const pdu       = is_intact ? frame.subspan(1, frame.size() - 3) : bytes{};
    auto const is_valid  = is_intact and rules::is_request(pdu);
    auto const has_room  = buffer.get().size() >= 4;

    // What cannot be answered, a broadcast or for want of room, is carried out only if it writes.
    auto const is_carried_out = is_heard and is_valid and ((is_own and has_room) or rules::is_write(pdu));
    FUZZ_ASSERT(handler.calls() == (is_carried_out ? 1U : 0U));
    if (not is_own or pdu[0] >= 0x80 or (is_valid and not rules::expects_reply(pdu))) {
        FUZZ_ASSERT(reply.empty());
        return 0;
    }
    if (buffer.get().size() >= 5) { FUZZ_ASSERT(not reply.empty()); }
    if (reply.empty()) { return 0; }
    FUZZ_ASSERT(reply.data() == buffer.get().data() and reply.size() <= buffer.get().size());
    check_reply(frame, reply, handler);

    // What is answered as asked, with room enough, is no exception. An identification may be, by the device's conformity.
    if (is_valid and handler.is_faithful() and buffer.get().size() >= 256 and not(pdu[0] == 0x2B and pdu[1] == 0x0E)) {
        FUZZ_ASSERT(reply[1] == pdu[0]);
    }
    return 0;
}

#ifdef FUZZ_ENGINE

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed)
{
    auto const mutated = LLVMFuzzerMutate(data, size, max_size);
    return mutate::repair_frame(data, 9, mutated, max_size, seed, mutate::pdu_kind::request);
}

#endif
