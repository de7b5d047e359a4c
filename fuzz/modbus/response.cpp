// Any bytes as the PDU of a response or an exception: see request.cpp.
#include "modbus/message_oracle.hpp"
#include "modbus/mutate_pdu.hpp"

using namespace oracle;

namespace {

void check_exception(bytes pdu, bool is_valid)
{
    auto const decoded = drivecodec::decode<modbus::exception_response>(pdu);
    FUZZ_ASSERT(decoded.has_value() == is_valid);
    if (not decoded) {
        check_fault(decoded.error(), pdu);
        return;
    }
    auto const encoded = encode_exactly(*decoded);
    FUZZ_ASSERT(encoded.get().size() == 2 and encoded.get()[0] == pdu.front() and encoded.get()[1] == pdu.back());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    bytes const pdu{data, size};
    auto const  is_valid     = rules::is_response(pdu);
    auto const  is_exception = not pdu.empty() and pdu[0] >= 0x80;
    FUZZ_ASSERT(modbus::exception_response::is_exception(pdu) == is_exception);

    check_exception(pdu, is_valid and is_exception);
    for_each_function([&]<typename Function>(Function const*) {
        using response = typename Function::response;
        if (is_of<Function>(pdu)) {
            check_message<response>(pdu, is_valid, false);
        } else {
            auto const fault = response::check(pdu);
            check_fault(fault, pdu);
            FUZZ_ASSERT(fault.code() == (size == 0 or (size == 1 and pdu[0] == modbus::to_byte(Function::code))
                                           ? errc::truncated
                                           : errc::unexpected_function));
        }
    });

    auto const visited = modbus::public_functions::visit_response<bool>(pdu, [&]<typename Response>(Response const& given) {
        auto const direct = drivecodec::decode<Response>(pdu);
        FUZZ_ASSERT(direct and *direct == given);
        return true;
    });
    FUZZ_ASSERT(visited.has_value() == is_valid);
    if (not visited) { check_fault(visited.error(), pdu); }

    check_lengths(pdu, [](bytes front) { return modbus::public_functions::response_length(front); });
    FUZZ_ASSERT(not is_valid or is_exception or modbus::public_functions::name(pdu) != nullptr);
    return 0;
}

#ifdef FUZZ_ENGINE

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed)
{
    auto const mutated = LLVMFuzzerMutate(data, size, max_size);
    return seed % 2 == 0 ? mutated : mutate::repair_pdu(data, mutated, max_size, mutate::pdu_kind::response);
}

#endif
