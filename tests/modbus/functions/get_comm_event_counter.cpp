#include <drivecodec/modbus/functions/get_comm_event_counter.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using counter = get_comm_event_counter::response;

TEST(get_comm_event_counter, is_what_the_specification_prints)
{
    VERIFY(encode(get_comm_event_counter::request{}) == vectors::get_comm_event_counter_request);
    VERIFY(encode(counter{.busy = true, .event_count = 264}) == vectors::get_comm_event_counter_response);
    VERIFY(*decode<counter>(vectors::get_comm_event_counter_response) == counter{.busy = true, .event_count = 264});
}

TEST(get_comm_event_counter, has_no_status_but_0000_and_FFFF)
{
    for (unsigned status = 0; status <= 0xFFFF; ++status) {
        auto const high = static_cast<std::uint8_t>(status >> 8);
        auto const low  = static_cast<std::uint8_t>(status);
        auto const ok   = status == 0 or status == 0xFFFF;
        ASSERT_EQ(counter::check(std::array<std::uint8_t, 5>{0x0B, high, low, 0, 0}),
                  (ok ? error{} : error{errc::bad_value, 1}))
            << status;
    }
}

TEST(get_comm_event_counter, survives_encoding_and_decoding_with_every_count)
{
    for (unsigned count = 0; count <= 0xFFFF; ++count) {
        counter const made{.busy = count % 2 != 0, .event_count = static_cast<std::uint16_t>(count)};
        auto const    wire  = encode(made);
        auto const    again = decode<counter>(wire);
        ASSERT_TRUE(again and *again == made) << count;
    }
    EXPECT_TRUE(properties::round_trips(counter{.busy = false, .event_count = 1}));
}

}  // namespace
