#include <drivecodec/fc/text_requests.hpp>

#include "support/fc_model.hpp"
#include "support/hex.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec::literals;
using drivecodec::bytes;
using drivecodec::encode;
using drivecodec::errc;
using drivecodec::error;
using namespace drivecodec::fc;
using fc_model::byte_list;

// AK F, and "04 00 H" as the index of a read command, "05 00 H" of a write command; 621 is 26Dh, 533 is 215h.
TEST(text_requests, read_with_ind_0400h_and_four_zeros)
{
    VERIFY(encode(read_text(621, data_not_valid)) == "F2 6D 04 00 00 00 00 00 00 00 00 00"_hex);
    VERIFY(encode(read_text(631, data_valid(0x047F, 50_percent))) == "F2 77 04 00 00 00 00 00 04 7F 20 00"_hex);
}

TEST(text_requests, write_with_ind_0500h_and_without_a_terminating_zero)
{
    VERIFY(encode(write_text(533, "HELLO", data_not_valid)) == "F2 15 05 00 48 45 4C 4C 4F 00 00 00 00"_hex);
    VERIFY(encode(write_text(534, "", data_valid(0x047F, 50_percent))) == "F2 16 05 00 04 7F 20 00"_hex);
    static constexpr char letters[]{'H', 'I', '\0'};
    VERIFY(encode(write_text(534, letters, data_not_valid)) == "F2 16 05 00 48 49 00 00 00 00"_hex);
    VERIFY(encode(write_text(534, "H\0I", data_not_valid)) == "F2 16 05 00 48 00 49 00 00 00 00"_hex);
}

// The manual says first that texts can only be read, then writes those of 533 and 534.
TEST(text_requests, write_although_the_manual_first_says_that_texts_can_only_be_read)
{
    VERIFY(write_text(533, "A", data_not_valid).access() == text_access::write);
    VERIFY(read_text(533, data_not_valid).access() == text_access::read);
}

TEST(text_requests, write_bytes_beyond_127_as_they_are)
{
    VERIFY(encode(write_text(533, "\xF8", data_not_valid)) == "F2 15 05 00 F8 00 00 00 00"_hex);
}

TEST(text_requests, write_up_to_244_characters)
{
    for (std::size_t size = 0; size <= 300; ++size) {
        byte_list const characters(size, 'x');
        auto const      made = make_write_text(533, characters, data_not_valid);
        ASSERT_EQ(made.has_value(), size <= 244) << size;
        if (not made) {
            ASSERT_EQ(made.error(), error(errc::bad_length, 0));
            continue;
        }
        ASSERT_EQ(made->characters.data(), characters.data());
        byte_list wanted{0xF2, 0x15, 0x05, 0x00};
        wanted.insert(wanted.end(), characters.begin(), characters.end());
        wanted.insert(wanted.end(), {0, 0, 0, 0});
        byte_list  buffer(300, 0xEE);
        auto const written = encode(*made, buffer);
        ASSERT_TRUE(written);
        ASSERT_EQ(byte_list(written->begin(), written->end()), wanted);
    }
}

TEST(text_requests, are_the_same_of_a_literal_and_at_run_time)
{
    static constexpr auto letters = "48 45 4C 4C 4F"_hex;
    static constexpr auto made    = make_write_text(533, letters, data_not_valid);
    VERIFY(made->wire_size() == 13);
    VERIFY([] {
        std::array<std::uint8_t, 13> out{};
        return encode(*made, out).has_value() and out == encode(write_text(533, "HELLO", data_not_valid));
    }());
}

TEST(text_requests, exist_in_every_layout)
{
    using wide = data_layout<4, 12>;
    VERIFY(encode(read_text<wide>(2048, data_not_valid)) == "F8 00 04 00 00 00 00 00 00 00 00 00 00 00 00 00"_hex);
    VERIFY(encode(write_text<wide>(2048, "AB", data_not_valid)) == "F8 00 05 00 41 42 00 00 00 00 00 00 00 00"_hex);
    std::array<std::uint8_t, 244> const many{};
    EXPECT_TRUE(make_write_text<wide>(2048, bytes{many}.first(240), data_not_valid));
    EXPECT_EQ(make_write_text<wide>(2048, bytes{many}.first(241), data_not_valid).error(), error(errc::bad_length, 0));
}

}  // namespace
