#include <drivecodec/text/modbus/visit_message.hpp>

#include "support/hex.hpp"
#include "support/pdu_vectors.hpp"
#include "support/verify.hpp"

#include <drivecodec/modbus/functions.hpp>

namespace {

namespace modbus = drivecodec::modbus;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using modbus::direction;

//=== in_the_light_of ===//

template <typename Function>
constexpr std::size_t coils_seen(bytes request, bytes response)
{
    auto const given = Function::response::read(response);
    return modbus::in_the_light_of(Function::request::read(request), given).values.size();
}

TEST(text_in_the_light_of, a_request_limits_the_coils_of_its_response)
{
    VERIFY(coils_seen<modbus::read_coils>(vectors::read_coils_request, vectors::read_coils_response) == 19);
    VERIFY(coils_seen<modbus::read_discrete_inputs>(vectors::read_discrete_inputs_request,
                                                    vectors::read_discrete_inputs_response)
           == 22);
}

TEST(text_in_the_light_of, another_request_changes_nothing)
{
    VERIFY(coils_seen<modbus::read_coils>("01 00 00 00 01"_hex, vectors::read_coils_response) == 24);
}

TEST(text_in_the_light_of, registers_are_what_they_are)
{
    VERIFY(coils_seen<modbus::read_holding_registers>(vectors::read_holding_registers_request,
                                                      vectors::read_holding_registers_response)
           == 3);
}

TEST(text_in_the_light_of, the_limited_response_is_as_long_as_before)
{
    constexpr auto size = [] {
        auto const asked = modbus::read_coils::request::read(vectors::read_coils_request);
        auto const given = modbus::read_coils::response::read(vectors::read_coils_response);
        return modbus::in_the_light_of(asked, given).wire_size();
    }();
    VERIFY(size == vectors::read_coils_response.size());
}

//=== visit_message ===//

/// What a visitor sees: the code of the message's function and, of coils, how many.
struct seen {
    int         calls = 0;
    std::size_t coils = 0;

    constexpr void operator()(auto const& message)
    {
        ++calls;
        if constexpr (requires { message.values.size(); }) { coils = message.values.size(); }
    }
};

constexpr bool visits(direction which, bytes pdu, bytes request, std::size_t coils)
{
    seen       visitor;
    auto const fault = modbus::visit_message<modbus::public_functions>(which, pdu, request, visitor);
    return fault.ok() and visitor.calls == 1 and visitor.coils == coils;
}

constexpr error refusal(direction which, bytes pdu)
{
    seen       visitor;
    auto const fault = modbus::visit_message<modbus::public_functions>(which, pdu, {}, visitor);
    return visitor.calls == 0 ? fault : error{};
}

TEST(text_visit_message, visits_requests_and_responses)
{
    VERIFY(visits(direction::request, vectors::read_coils_request, {}, 0));
    VERIFY(visits(direction::response, vectors::read_coils_response, {}, 24));
    VERIFY(visits(direction::response, vectors::read_coils_response, vectors::read_coils_request, 19));
    VERIFY(visits(direction::response, vectors::exception_response, vectors::exception_request, 0));
}

TEST(text_visit_message, ignores_a_request_that_is_none_of_this_function)
{
    VERIFY(visits(direction::response, vectors::read_coils_response, vectors::read_discrete_inputs_request, 24));
    VERIFY(visits(direction::response, vectors::read_coils_response, bytes{vectors::read_coils_request}.first(4), 24));
}

TEST(text_visit_message, says_what_does_not_decode)
{
    VERIFY(refusal(direction::request, {}) == error{errc::truncated, 1});
    VERIFY(refusal(direction::request, "03 00 00 00 7E"_hex) == error{errc::bad_quantity, 3});
    VERIFY(refusal(direction::request, "41 00"_hex) == error{errc::unsupported_function, 0});
    VERIFY(refusal(direction::response, "03 03 00 00 00"_hex) == error{errc::bad_length, 1});
    VERIFY(refusal(direction::response, "83 02 00"_hex) == error{errc::trailing_bytes, 2});
}

TEST(text_visit_message, visits_everything_that_the_specification_prints)
{
    for (std::size_t i = 0; i < vectors::printed_requests.size(); ++i) {
        auto const request  = vectors::printed_requests[i].pdu;
        auto const response = vectors::printed_responses[i].pdu;
        seen       visitor;
        using functions = modbus::public_functions;
        EXPECT_TRUE(modbus::visit_message<functions>(direction::request, request, {}, visitor).ok());
        EXPECT_TRUE(modbus::visit_message<functions>(direction::response, response, request, visitor).ok());
        EXPECT_EQ(visitor.calls, 2) << vectors::printed_requests[i].name;
    }
}

}  // namespace
