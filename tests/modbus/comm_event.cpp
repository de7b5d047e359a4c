#include <drivecodec/modbus/comm_event.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::modbus::comm_event;
using drivecodec::modbus::comm_event_kind;

constexpr comm_event event(std::uint8_t raw) { return comm_event::from_raw(raw); }

// MODBUS Application Protocol V1.1b3, 6.10: bit 7 tells a receive event, bit 6 without it a send event.
TEST(comm_event, has_a_kind_for_each_byte)
{
    for (unsigned raw = 0; raw <= 0xFF; ++raw) {
        auto expected = comm_event_kind::unknown;
        if (raw >= 0x80) {
            expected = comm_event_kind::receive;
        } else if (raw >= 0x40) {
            expected = comm_event_kind::send;
        } else if (raw == 0x04) {
            expected = comm_event_kind::entered_listen_only_mode;
        } else if (raw == 0x00) {
            expected = comm_event_kind::communication_restart;
        }
        EXPECT_EQ(event(static_cast<std::uint8_t>(raw)).kind(), expected) << raw;
        EXPECT_EQ(event(static_cast<std::uint8_t>(raw)).raw, raw);
    }
    VERIFY(event(0x80).kind() == comm_event_kind::receive);
    VERIFY(event(0x40).kind() == comm_event_kind::send);
    VERIFY(event(0x04).kind() == comm_event_kind::entered_listen_only_mode);
    VERIFY(event(0x00).kind() == comm_event_kind::communication_restart);
    VERIFY(event(0x20).kind() == comm_event_kind::unknown);
}

TEST(comm_event, tells_what_was_received)
{
    VERIFY(event(0x82).test(comm_event::communication_error));
    VERIFY(event(0x90).test(comm_event::character_overrun));
    VERIFY(event(0xA0).test(comm_event::in_listen_only_mode));
    VERIFY(event(0xC0).test(comm_event::broadcast_received));
    VERIFY(not event(0x80).test(comm_event::communication_error));
}

TEST(comm_event, tells_what_was_sent)
{
    VERIFY(event(0x41).test(comm_event::read_exception_sent));
    VERIFY(event(0x42).test(comm_event::server_abort_exception_sent));
    VERIFY(event(0x44).test(comm_event::server_busy_exception_sent));
    VERIFY(event(0x48).test(comm_event::program_nak_exception_sent));
    VERIFY(event(0x50).test(comm_event::write_timeout));
    VERIFY(event(0x60).test(comm_event::in_listen_only_mode));
}

}  // namespace
