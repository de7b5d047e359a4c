#include <drivecodec/modbus/functions/report_server_id.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using response = report_server_id::response;

constexpr auto wire = "11 06 4D 43 34 FF 01 02"_hex;  // "MC4", on, two bytes more
constexpr auto data = "4D 43 34 FF 01 02"_hex;

TEST(report_server_id, has_a_byte_count_and_bytes)
{
    VERIFY(encode(report_server_id::request{}) == "11"_hex);
    VERIFY(*decode<response>(wire) == *response::make(data));
    VERIFY(same_bytes(decode<response>(wire)->data(), data));
    EXPECT_EQ(properties::wire_of(*response::make(data)), properties::copy_of(wire));
}

TEST(report_server_id, is_split_by_who_knows_the_length_of_the_id)
{
    constexpr auto parts = *decode<response>(wire)->split(3);
    VERIFY(same_bytes(parts.server_id, "4D 43 34"_hex));
    VERIFY(parts.run_indicator == report_server_id::identity::on);
    VERIFY(same_bytes(parts.additional_data, "01 02"_hex));
    VERIFY(decode<response>(wire)->split(0)->run_indicator == 0x4D);
    VERIFY(decode<response>(wire)->split(5)->additional_data.empty());
    VERIFY(decode<response>(wire)->split(6).error() == error{errc::bad_length, 1});
    VERIFY(decode<response>(wire)->split(1000).error() == error{errc::bad_length, 1});
}

TEST(report_server_id, has_1_to_251_bytes)
{
    properties::byte_vector const bytes_to_send(252, 0xA5);
    for (std::size_t size = 1; size <= 251; ++size) {
        auto const made = response::make(bytes{bytes_to_send}.first(size));
        ASSERT_TRUE(made) << size;
        ASSERT_TRUE(properties::round_trips(*made)) << size;
    }
    EXPECT_EQ(response::make({}).error(), (error{errc::bad_quantity, 1}));
    EXPECT_EQ(response::make(bytes_to_send).error(), (error{errc::bad_quantity, 1}));

    for (unsigned size = 0; size <= 0xFF; ++size) {
        properties::byte_vector pdu(2 + size);
        pdu[0] = 0x11;
        pdu[1] = static_cast<std::uint8_t>(size);
        EXPECT_EQ(response::check(pdu), (size == 0 or size > 251 ? error{errc::bad_quantity, 1} : error{})) << size;
    }
}

TEST(report_server_id, compares_bytes)
{
    VERIFY(*response::make(data) != *response::make(bytes{data}.first(5)));
}

}  // namespace
