#include <drivecodec/modbus/messages/bare_request.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

struct ping {
    static constexpr auto code = static_cast<function_code>(0x42);
};
using request = bare_request<ping>;

TEST(bare_request, is_its_function_code)
{
    VERIFY(encode(request{}) == "42"_hex);
    VERIFY(*decode<request>("42"_hex) == request{});
    VERIFY(request::length({}) == message_length::exactly(1));
}

TEST(bare_request, is_nothing_else)
{
    VERIFY(request::check({}) == error{errc::truncated, 1});
    VERIFY(request::check("42 00"_hex) == error{errc::trailing_bytes, 1});
    VERIFY(request::check("43"_hex) == error{errc::unexpected_function, 0});
}

TEST(bare_request, is_answered_by_every_response)
{
    VERIFY(request{}.matches(1).ok());
}

}  // namespace
