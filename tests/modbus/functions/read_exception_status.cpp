#include <drivecodec/modbus/functions/read_exception_status.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = read_exception_status::request;
using response = read_exception_status::response;

TEST(read_exception_status, is_what_the_specification_prints)
{
    VERIFY(encode(request{}) == vectors::read_exception_status_request);
    VERIFY(*decode<request>(vectors::read_exception_status_request) == request{});
    VERIFY(encode(response{.outputs = 0x6D}) == vectors::read_exception_status_response);
    VERIFY(decode<response>(vectors::read_exception_status_response)->outputs == 0x6D);
    VERIFY(response::make(0x6D) == response{.outputs = 0x6D});
}

TEST(read_exception_status, survives_encoding_and_decoding_with_every_value)
{
    for (unsigned outputs = 0; outputs <= 0xFF; ++outputs) {
        ASSERT_TRUE(properties::round_trips(response{.outputs = static_cast<std::uint8_t>(outputs)})) << outputs;
    }
}

TEST(read_exception_status, is_answered_by_every_response)
{
    VERIFY(request{}.matches(response{.outputs = 0}).ok());
}

}  // namespace
