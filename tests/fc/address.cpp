#include <drivecodec/fc/address.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::errc;
using drivecodec::error;
using drivecodec::fc::address;
using drivecodec::fc::address_format;
using drivecodec::fc::long_broadcast;
using drivecodec::fc::short_broadcast;

// VLT 6000 manual, "VLT frequency converter address (ADR)".
TEST(address, is_22_as_in_the_example)
{
    VERIFY(address::short_format(22).byte() == 0x16);
    VERIFY(address::short_format(22).number() == 22);
    VERIFY(address::long_format(22).byte() == 0x96);
    VERIFY(address::long_format(22).number() == 22);
    VERIFY(address::short_format(22) != address::long_format(22));
}

TEST(address, is_a_constant_up_to_the_ends)
{
    VERIFY(address::short_format(1).byte() == 0x01 and address::short_format(31).byte() == 0x1F);
    VERIFY(address::long_format(1).byte() == 0x81 and address::long_format(126).byte() == 0xFE);
    static_assert(sizeof(address) == 1);
}

TEST(address, is_broadcast_by_name)
{
    VERIFY(short_broadcast.byte() == 0x20 and short_broadcast.is_broadcast() and not short_broadcast.is_reserved());
    VERIFY(long_broadcast.byte() == 0x80 and long_broadcast.is_broadcast() and not long_broadcast.is_reserved());
    VERIFY(short_broadcast.number() == 0 and long_broadcast.number() == 0);
    VERIFY(short_broadcast.format() == address_format::short_1_to_31);
    VERIFY(long_broadcast.format() == address_format::long_1_to_126);
}

/// The manual's two pictures of ADR, in strings.
struct drawn {
    bool is_long;
    bool is_broadcast;
    int  number;
};
drawn draw(int byte)
{
    std::string bits;
    for (int bit = 7; bit >= 0; --bit) { bits += (byte >> bit) % 2 == 0 ? '0' : '1'; }
    auto const number_of = [](std::string const& digits) { return std::stoi(digits, nullptr, 2); };
    if (bits[0] == '0') {
        auto const is_broadcast = bits[2] == '1';
        return {false, is_broadcast, is_broadcast ? 0 : number_of(bits.substr(3))};
    }
    auto const number = number_of(bits.substr(1));
    return {true, number == 0, number};
}

TEST(address, is_read_from_every_byte)
{
    int broadcasts = 0;
    int reserved   = 0;
    for (int byte = 0; byte <= 0xFF; ++byte) {
        auto const read   = address::from_byte(static_cast<std::uint8_t>(byte));
        auto const wanted = draw(byte);
        ASSERT_EQ(read.byte(), byte);
        ASSERT_EQ(read.format(), wanted.is_long ? address_format::long_1_to_126 : address_format::short_1_to_31)
            << byte;
        ASSERT_EQ(read.is_broadcast(), wanted.is_broadcast) << byte;
        ASSERT_EQ(read.number(), wanted.number) << byte;
        ASSERT_EQ(read.is_reserved(), byte == 0x00 or byte == 0x40 or byte == 0xFF) << byte;
        broadcasts += read.is_broadcast() ? 1 : 0;
        reserved += read.is_reserved() ? 1 : 0;
    }
    EXPECT_EQ(broadcasts, 32 + 32 + 1);  // 20h to 3Fh, 60h to 7Fh, 80h
    EXPECT_EQ(reserved, 3);
}

TEST(address, is_made_of_every_number_that_a_format_has)
{
    for (int number = 0; number <= 0xFF; ++number) {
        auto const in_short = address::make(address_format::short_1_to_31, static_cast<std::uint8_t>(number));
        ASSERT_EQ(in_short.has_value(), number >= 1 and number <= 31) << number;
        if (in_short) {
            ASSERT_EQ(in_short->byte(), number);
            ASSERT_EQ(in_short->number(), number);
        } else {
            ASSERT_EQ(in_short.error(), error(errc::reserved_address, 0)) << number;
        }
        auto const in_long = address::make(address_format::long_1_to_126, static_cast<std::uint8_t>(number));
        ASSERT_EQ(in_long.has_value(), number >= 1 and number <= 126) << number;
        if (in_long) {
            ASSERT_EQ(in_long->byte(), number + 128);
            ASSERT_EQ(in_long->number(), number);
        } else {
            ASSERT_EQ(in_long.error(), error(errc::reserved_address, 0)) << number;
        }
    }
}

// Parameter 501 can be 0, but neither format has a slave 0; the longer one has 127, which 501 cannot be.
TEST(address, of_parameter_501_may_be_0_but_no_telegram_reaches_it)
{
    VERIFY(address::make(address_format::short_1_to_31, 0).error() == error{errc::reserved_address, 0});
    VERIFY(address::make(address_format::long_1_to_126, 0).error() == error{errc::reserved_address, 0});
    VERIFY(address::make(address_format::long_1_to_126, 127).error() == error{errc::reserved_address, 0});
    VERIFY(address::from_byte(0x00).is_reserved() and not address::from_byte(0x00).is_broadcast());
    VERIFY(address::from_byte(0xFF).is_reserved() and address::from_byte(0xFF).number() == 127);
}

TEST(address, keeps_the_unused_bit_6_but_is_never_made_with_it)
{
    for (int byte = 0; byte < 0x40; ++byte) {
        auto const without = address::from_byte(static_cast<std::uint8_t>(byte));
        auto const with    = address::from_byte(static_cast<std::uint8_t>(byte | 0x40));
        ASSERT_EQ(with.byte(), byte | 0x40);
        ASSERT_EQ(with.number(), without.number());
        ASSERT_EQ(with.is_broadcast(), without.is_broadcast());
        ASSERT_EQ(with.is_reserved(), without.is_reserved());
        ASSERT_NE(with, without);
    }
    for (std::uint8_t number = 1; number <= 31; ++number) {
        ASSERT_EQ(address::make(address_format::short_1_to_31, number)->byte() & 0x40, 0);
    }
}

}  // namespace
