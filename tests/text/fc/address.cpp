#include <drivecodec/text/fc/address.hpp>

#include "support/verify.hpp"

#include <drivecodec/text/core.hpp>

#include <array>
#include <string>

namespace {

using drivecodec::describe;
using drivecodec::fc::address;

constexpr bool reads(address of, std::string_view expected)
{
    std::array<char, 40> room{};
    return describe(of, room) == expected;
}

TEST(text_fc_address, is_the_number_of_a_slave_in_either_format)
{
    VERIFY(reads(address::short_format(1), "slave 1"));
    VERIFY(reads(address::short_format(22), "slave 22"));
    VERIFY(reads(address::long_format(22), "slave 22"));
    VERIFY(reads(address::long_format(126), "slave 126"));
}

TEST(text_fc_address, is_a_broadcast_whatever_else_it_says)
{
    VERIFY(reads(drivecodec::fc::short_broadcast, "broadcast"));
    VERIFY(reads(drivecodec::fc::long_broadcast, "broadcast"));
    VERIFY(reads(address::from_byte(0x3F), "broadcast"));
    VERIFY(reads(address::from_byte(0x61), "broadcast"));
}

TEST(text_fc_address, shows_what_no_master_should_send)
{
    VERIFY(reads(address::from_byte(0x00), "reserved address 00"));
    VERIFY(reads(address::from_byte(0x40), "reserved address 40"));
    VERIFY(reads(address::from_byte(0xFF), "reserved address FF"));
    VERIFY(reads(address::from_byte(0x56), "slave 22 (ADR 56)"));
}

TEST(text_fc_address, tells_all_256_bytes_of_the_long_format_and_the_short_one_apart_from_broadcasts)
{
    for (unsigned byte = 0; byte <= 0xFF; ++byte) {
        std::array<char, 40> room{};
        auto const           text         = describe(address::from_byte(static_cast<std::uint8_t>(byte)), room);
        auto const           is_broadcast = byte == 0x80 or (byte < 0x80 and byte / 0x20 % 2 == 1);
        EXPECT_EQ(text == "broadcast", is_broadcast) << byte;
        if (byte > 0x80 and byte < 0xFF) { EXPECT_EQ(text, "slave " + std::to_string(byte - 0x80)); }
        if (byte > 0 and byte < 0x20) { EXPECT_EQ(text, "slave " + std::to_string(byte)); }
    }
}

}  // namespace
