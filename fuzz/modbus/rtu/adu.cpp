// Any bytes as one RTU frame, as every request and every response.
#include "modbus/message_oracle.hpp"
#include "modbus/mutate_pdu.hpp"

#include <drivecodec/modbus/rtu/adu.hpp>

using namespace oracle;

namespace {

namespace rtu = modbus::rtu;

template <typename Message>
void check_frame(bytes frame, bool is_of_it, bool is_valid, bool is_request)
{
    using adu          = rtu::adu<Message>;
    auto const decoded = rtu::decode<Message>(frame);
    FUZZ_ASSERT(decoded.has_value() == (is_of_it and is_valid));
    if (not decoded) {
        check_fault(decoded.error(), frame);
        // A damaged frame is not the other side's fault.
        auto const code = decoded.error().code();
        FUZZ_ASSERT(code == errc::truncated or code == errc::bad_checksum or frame.size() > 256 or has_reference_crc16(frame));
        return;
    }

    auto const encoded = encode_exactly(*decoded);
    FUZZ_ASSERT(encoded.get().size() == frame.size() and encoded.get()[0] == frame[0]);
    auto const pdu = frame.subspan(1, frame.size() - 3);
    for (std::size_t i = 0; i < pdu.size(); ++i) {
        FUZZ_ASSERT(encoded.get()[i + 1] == rules::normal_byte(pdu, i, is_request));
    }
    FUZZ_ASSERT(has_reference_crc16(encoded.get()));

    exact_buffer const by_gate{frame.size()};
    auto const         written = rtu::encode(decoded->address, decoded->message, by_gate.get());
    FUZZ_ASSERT(written and rules::is_same(by_gate.get(), encoded.get()));
    auto const again = rtu::decode<Message>(bytes{encoded.get()});
    FUZZ_ASSERT(again and *again == *decoded);

    if (rules::ends_with_silence(pdu)) { return; }
    std::size_t needed = 0;
    for (std::size_t size = 0; size < frame.size(); ++size) {
        auto const cut = adu::check(frame.first(size));
        FUZZ_ASSERT(cut.code() == errc::truncated);
        FUZZ_ASSERT(cut.offset() > size and cut.offset() >= needed and cut.offset() <= frame.size());
        needed = cut.offset();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    bytes const frame{data, size};
    auto const  is_intact = size >= 4 and size <= 256 and has_reference_crc16(frame);
    auto const  pdu       = size >= 4 ? frame.subspan(1, size - 3) : bytes{};
    FUZZ_ASSERT(size < 2 or rtu::has_valid_crc(frame) == has_reference_crc16(frame));

    auto const is_request  = is_intact and rules::is_request(pdu);
    auto const is_response = is_intact and rules::is_response(pdu);
    for_each_function([&]<typename Function>(Function const*) {
        check_frame<typename Function::request>(frame, is_of<Function>(pdu), is_request, true);
        check_frame<typename Function::response>(frame, is_of<Function>(pdu), is_response, false);
    });
    return 0;
}

#ifdef FUZZ_ENGINE

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed)
{
    auto const mutated = LLVMFuzzerMutate(data, size, max_size);
    auto const kind    = seed / 16 % 2 == 0 ? mutate::pdu_kind::request : mutate::pdu_kind::response;
    return mutate::repair_frame(data, 0, mutated, max_size, seed, kind);
}

#endif
