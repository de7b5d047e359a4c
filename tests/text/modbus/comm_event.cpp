#include <drivecodec/text/modbus/comm_event.hpp>

#include "support/enum_names.hpp"
#include "support/hex.hpp"
#include "support/verify.hpp"

#include <array>

namespace {

using drivecodec::text_writer;
using drivecodec::modbus::comm_event;
using drivecodec::modbus::comm_event_kind;
using drivecodec::modbus::comm_event_list;

constexpr bool reads(std::uint8_t raw, std::string_view expected)
{
    std::array<char, 200> buffer{};
    text_writer           out{buffer};
    write_text(out, comm_event::from_raw(raw));
    return out.view() == expected;
}

TEST(text_comm_event_kind, has_a_name_for_every_kind)
{
    EXPECT_EQ(names_of_all_values<comm_event_kind>().size(), 5);
    VERIFY(to_string(comm_event_kind::entered_listen_only_mode) == "entered_listen_only_mode");
    VERIFY(to_string(comm_event_kind::unknown) == "unknown");
}

TEST(text_comm_event, explains_the_byte)
{
    VERIFY(reads(0x00, "communication_restart"));
    VERIFY(reads(0x04, "entered_listen_only_mode"));
    VERIFY(reads(0x80, "receive"));
    VERIFY(reads(0xC2, "receive+communication_error+broadcast_received"));
    VERIFY(reads(0xFF, "receive+communication_error+character_overrun+in_listen_only_mode+broadcast_received"));
    VERIFY(reads(0x40, "send"));
    VERIFY(reads(0x41, "send+read_exception_sent"));
    VERIFY(reads(0x7F, "send+read_exception_sent+server_abort_exception_sent+server_busy_exception_sent"
                       "+program_nak_exception_sent+write_timeout+in_listen_only_mode"));
}

TEST(text_comm_event, shows_what_nobody_knows_as_a_number)
{
    VERIFY(reads(0x20, "0x20"));
    VERIFY(reads(0x05, "0x05"));
}

TEST(text_comm_event, says_something_of_every_byte)
{
    for (unsigned raw = 0; raw <= 0xFF; ++raw) {
        text_writer measured;
        write_text(measured, comm_event::from_raw(static_cast<std::uint8_t>(raw)));
        EXPECT_GT(measured.needed(), 0) << raw;
    }
}

TEST(text_comm_event_list, walks_the_log)
{
    static constexpr auto log = "80 40 00"_hex;
    constexpr comm_event_list events{log};
    VERIFY(events.size() == 3);
    VERIFY(events[1].kind() == comm_event_kind::send);
    std::size_t at = 0;
    for (auto const event : events) { EXPECT_EQ(event.raw, log[at++]); }
    EXPECT_EQ(at, 3);
}

}  // namespace
