#include <drivecodec/modbus/functions/canopen_general_reference.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = canopen_general_reference::request;
using response = canopen_general_reference::response;

constexpr auto payload = "60 01 02"_hex;
constexpr auto wire    = "2B 0D 60 01 02"_hex;

TEST(canopen_general_reference, carries_bytes)
{
    VERIFY(same_bytes(decode<request>(wire)->payload(), payload));
    VERIFY(*decode<request>(wire) == *request::make(payload));
    VERIFY(*decode<response>(wire) == *response::make(payload));
    VERIFY(*decode<response>(wire) != *response::make({}));
    EXPECT_EQ(properties::wire_of(*request::make(payload)), properties::copy_of(wire));
}

TEST(canopen_general_reference, carries_up_to_251_bytes)
{
    properties::byte_vector const longest(252, 0x5A);
    for (std::size_t size = 0; size <= 251; ++size) {
        ASSERT_TRUE(properties::round_trips(*request::make(bytes{longest}.first(size)))) << size;
        ASSERT_TRUE(properties::round_trips(*response::make(bytes{longest}.first(size)))) << size;
    }
    EXPECT_EQ(request::make(longest).error(), (error{errc::bad_quantity, 2}));
    EXPECT_EQ(response::make(longest).error(), (error{errc::bad_quantity, 2}));
}

TEST(canopen_general_reference, has_an_mei_type)
{
    VERIFY(request::check("2B"_hex) == error{errc::truncated, 2});
    VERIFY(request::check("2B 0D"_hex).ok());
    VERIFY(request::check("2B 0E"_hex) == error{errc::unexpected_function, 1});
    VERIFY(request::length("2B 0D"_hex).is_until_silence());
}

TEST(canopen_general_reference, is_answered_by_every_response)
{
    VERIFY(request::make(payload)->matches(*response::make({})).ok());
}

}  // namespace
