// Any request, and any frame as its reply, or the server's reply with one byte changed: the client takes what answers the
// request, and nothing else.
//
// Input: the address asked, whether the reply is the server's, the server's manner (6 bytes), where and how to change the
// reply (2 bytes), the size of the request's PDU, the request's PDU, the reply.
#include "modbus/handler.hpp"
#include "modbus/message_oracle.hpp"
#include "modbus/mutate_pdu.hpp"

#include <drivecodec/modbus/rtu/client.hpp>
#include <drivecodec/modbus/rtu/server.hpp>

using namespace oracle;

namespace {

namespace rtu = modbus::rtu;

template <typename Request>
void check_reply(std::uint8_t address, Request const& asked, bytes request, bytes frame)
{
    auto const server = rtu::server_address::reserved(address);
    auto const taken  = rtu::check(server, asked, frame);

    auto const waits     = address != 0 and rules::expects_reply(request);
    auto const is_intact = frame.size() >= 4 and frame.size() <= 256 and has_reference_crc16(frame);
    auto const pdu       = is_intact ? frame.subspan(1, frame.size() - 3) : bytes{};
    auto const is_valid  = is_intact and frame[0] == address and rules::is_response(pdu);
    auto const is_reply  = waits and is_valid and pdu[0] < 0x80 and rules::answers(request, pdu);
    FUZZ_ASSERT(rtu::expects_reply(server, asked) == waits);
    FUZZ_ASSERT(taken.has_value() == is_reply);
    if (taken) {
        FUZZ_ASSERT(taken->wire_size() == pdu.size());
        auto const direct = drivecodec::decode<typename Request::function::response>(pdu);
        FUZZ_ASSERT(direct and *direct == *taken);
        return;
    }

    auto const why = taken.error();
    if (why.code() == errc::exception_reply) {
        FUZZ_ASSERT(waits and is_valid and rules::is_exception(pdu) and (pdu[0] & 0x7F) == request[0]);
        FUZZ_ASSERT(static_cast<std::uint8_t>(why.exception()) == pdu.back());
        return;
    }
    FUZZ_ASSERT(not(waits and is_valid and pdu[0] >= 0x80 and (pdu[0] & 0x7F) == request[0]));
    FUZZ_ASSERT((why.code() == errc::no_reply) == not waits);
    FUZZ_ASSERT(why.code() != errc::truncated or why.offset() > frame.size());
    FUZZ_ASSERT(why.code() == errc::truncated or why.code() == errc::no_reply or why.offset() < frame.size());
    if (waits and not is_intact and frame.size() <= 256) {
        FUZZ_ASSERT(why.code() == errc::truncated or why.code() == errc::bad_checksum);
    }
    if (waits and is_intact and frame[0] != address) {
        FUZZ_ASSERT(why.code() == errc::truncated or why.code() == errc::unexpected_server);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input   input{data, size};
    auto const   address     = input.u8();
    auto const   from_server = input.u8() % 2 != 0;
    fuzz_input   manner{input.take(6)};
    full_handler handler{manner};
    auto const   where   = input.u8();
    auto const   change  = input.u8();
    bytes const  request = input.take(input.u8());
    bytes const  given   = input.rest();

    static_cast<void>(modbus::public_functions::visit_request<bool>(request, [&](auto const& asked) {
        if (not from_server) {
            check_reply(address, asked, request, given);
            return true;
        }
        auto const         encoded = encode_exactly(rtu::adu<std::remove_cvref_t<decltype(asked)>>{
            rtu::server_address::reserved(address), asked});
        exact_buffer const buffer{256};
        auto const reply = rtu::serve(rtu::server_address::reserved(address), encoded.get(), buffer.get(), handler);
        if (reply.empty()) { return true; }

        // The unused bits of coils are not part of the request, nor of its echo.
        auto const asked_pdu = bytes{encoded.get()}.subspan(1, encoded.get().size() - 3);
        check_reply(address, asked, asked_pdu, reply);
        auto const changed = buffer.get().first(reply.size());
        changed[where % (reply.size() - 2)] ^= change;
        if (change != 0) { check_reply(address, asked, asked_pdu, changed); }  // the CRC does not fit
        repair_crc16(changed);
        check_reply(address, asked, asked_pdu, changed);
        return true;
    }));

    // One's own request as an echo before the reply.
    auto const skipped = rtu::skip_echo(request, given);
    auto const is_echo = rules::starts_alike(request, given, request.size());
    FUZZ_ASSERT(skipped.has_value() == is_echo);
    if (is_echo) { FUZZ_ASSERT(rules::is_same(*skipped, given.subspan(request.size()))); }
    return 0;
}

#ifdef FUZZ_ENGINE

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed)
{
    auto const mutated = LLVMFuzzerMutate(data, size, max_size);
    auto const begin   = mutated < 11 ? mutated : std::size_t{11} + data[10];
    return mutate::repair_frame(data, begin < mutated ? begin : mutated, mutated, max_size, seed, mutate::pdu_kind::response);
}

#endif
