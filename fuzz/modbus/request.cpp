// Any bytes as the PDU of a request: what is valid is what the rules say, decoding and encoding are inverse, the lengths
// agree, and dispatch gives what decoding by the type gives.
#include "modbus/message_oracle.hpp"
#include "modbus/mutate_pdu.hpp"

using namespace oracle;

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    bytes const pdu{data, size};
    auto const  is_valid = rules::is_request(pdu);

    for_each_function([&]<typename Function>(Function const*) {
        using request = typename Function::request;
        if (is_of<Function>(pdu)) {
            check_message<request>(pdu, is_valid, true);
        } else {
            auto const fault = request::check(pdu);
            check_fault(fault, pdu);
            FUZZ_ASSERT(fault.code() == (size == 0 or (size == 1 and pdu[0] == modbus::to_byte(Function::code))
                                           ? errc::truncated
                                           : errc::unexpected_function));
        }
    });

    auto const visited = modbus::public_functions::visit_request<bool>(pdu, [&]<typename Request>(Request const& asked) {
        auto const direct = drivecodec::decode<Request>(pdu);
        FUZZ_ASSERT(direct and *direct == asked);
        FUZZ_ASSERT(modbus::expects_reply(asked) == rules::expects_reply(pdu));
        FUZZ_ASSERT(modbus::is_write<typename Request::function>() == rules::is_write(pdu));
        return true;
    });
    FUZZ_ASSERT(visited.has_value() == is_valid);
    if (not visited) { check_fault(visited.error(), pdu); }

    check_lengths(pdu, [](bytes front) { return modbus::public_functions::request_length(front); });
    FUZZ_ASSERT(not is_valid or modbus::public_functions::name(pdu) != nullptr);
    FUZZ_ASSERT(not is_valid or modbus::public_functions::expects_reply(pdu) == rules::expects_reply(pdu));
    return 0;
}

#ifdef FUZZ_ENGINE

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed)
{
    auto const mutated = LLVMFuzzerMutate(data, size, max_size);
    return seed % 2 == 0 ? mutated : mutate::repair_pdu(data, mutated, max_size, mutate::pdu_kind::request);
}

#endif
