#include <drivecodec/modbus/functions/get_comm_event_log.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using event_log = get_comm_event_log::response;

TEST(get_comm_event_log, is_what_the_specification_prints)
{
    static constexpr auto events = "20 00"_hex;
    constexpr auto        given  = *decode<event_log>(vectors::get_comm_event_log_response);
    VERIFY(encode(get_comm_event_log::request{}) == vectors::get_comm_event_log_request);
    VERIFY(not given.busy() and given.event_count() == 264 and given.message_count() == 289);
    VERIFY(given == *event_log::make(false, 264, 289, events));
    VERIFY(given.events().size() == 2 and given.event(0).raw == 0x20);
    VERIFY(given.event(1).kind() == comm_event_kind::communication_restart);
    EXPECT_EQ(properties::wire_of(*event_log::make(false, 264, 289, events)),
              properties::copy_of(vectors::get_comm_event_log_response));
}

TEST(get_comm_event_log, has_no_status_but_0000_and_FFFF)
{
    for (unsigned status = 0; status <= 0xFFFF; ++status) {
        auto const high = static_cast<std::uint8_t>(status >> 8);
        auto const low  = static_cast<std::uint8_t>(status);
        auto const ok   = status == 0 or status == 0xFFFF;
        ASSERT_EQ(event_log::check(std::array<std::uint8_t, 8>{0x0C, 6, high, low, 0, 0, 0, 0}),
                  (ok ? error{} : error{errc::bad_value, 2}))
            << status;
    }
}

TEST(get_comm_event_log, has_up_to_64_events)
{
    properties::byte_vector const events(65);
    for (std::size_t count = 0; count <= 64; ++count) {
        auto const made = event_log::make(true, 1, 2, bytes{events}.first(count));
        ASSERT_TRUE(made) << count;
        ASSERT_TRUE(properties::round_trips(*made)) << count;
    }
    EXPECT_EQ(event_log::make(true, 1, 2, events).error(), (error{errc::bad_quantity, 1}));
}

TEST(get_comm_event_log, has_a_byte_count_from_6_to_70)
{
    for (unsigned size = 0; size <= 0xFF; ++size) {
        properties::byte_vector pdu(2 + size);
        pdu[0] = 0x0C;
        pdu[1] = static_cast<std::uint8_t>(size);

        auto expected = error{};
        if (size < 6) { expected = {errc::bad_length, 1}; }
        if (size > 70) { expected = {errc::bad_quantity, 1}; }
        EXPECT_EQ(event_log::check(pdu), expected) << size;
    }
}

TEST(get_comm_event_log, keeps_every_event_byte)
{
    for (unsigned raw = 0; raw <= 0xFF; ++raw) {
        std::array<std::uint8_t, 1> const events{static_cast<std::uint8_t>(raw)};
        auto const                        wire = properties::wire_of(*event_log::make(false, 0, 0, events));
        EXPECT_EQ(decode<event_log>(wire)->event(0).raw, raw);
    }
}

TEST(get_comm_event_log, compares_every_field)
{
    static constexpr auto one   = "80"_hex;
    static constexpr auto other = "81"_hex;
    constexpr auto        made  = *event_log::make(true, 1, 2, one);
    VERIFY(made == *event_log::make(true, 1, 2, one));
    VERIFY(made != *event_log::make(false, 1, 2, one));
    VERIFY(made != *event_log::make(true, 0, 2, one));
    VERIFY(made != *event_log::make(true, 1, 0, one));
    VERIFY(made != *event_log::make(true, 1, 2, other));
    VERIFY(made != *event_log::make(true, 1, 2, {}));
}

}  // namespace
