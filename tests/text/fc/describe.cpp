#include <drivecodec/text/fc/describe.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <drivecodec/fc/reader.hpp>
#include <drivecodec/text/core.hpp>

#include <array>
#include <string>
#include <vector>

namespace {

namespace fc = drivecodec::fc;
using drivecodec::bytes;
using fc::direction;

// BCC is of no interest here.
constexpr auto read_202   = "02 0E 01 10 CA 00 00 00 00 00 00 04 7F 20 00 00"_hex;
constexpr auto word_202   = "02 0E 01 10 CA 00 00 00 00 03 E8 0F 03 20 00 00"_hex;
constexpr auto refused    = "02 0E 01 70 CA 00 00 00 00 00 02 0F 03 20 00 00"_hex;
constexpr auto process    = "02 06 01 04 7F 20 00 00"_hex;
constexpr auto read_621   = "02 0E 01 F2 6D 04 00 00 00 00 00 00 00 00 00 00"_hex;
constexpr auto text_621   = "02 12 01 F2 6D 04 00 56 4C 54 20 36 30 30 30 0F 03 20 00 00"_hex;
constexpr auto six_bytes  = "02 08 01 01 02 03 04 05 06 00"_hex;
constexpr auto many_words = "02 0E 01 04 7F 20 00 00 01 00 02 00 03 00 04 00"_hex;

template <typename Layout = fc::vlt_layout>
constexpr bool reads(bytes raw, direction which, std::string_view expected, bool aligned = true)
{
    std::array<char, 200> room{};
    return fc::describe<Layout>(fc::frame{raw, which, aligned}, room) == expected;
}

TEST(text_fc_describe, shows_requests)
{
    VERIFY(reads(process, direction::request, "request to slave 1: PCD 047F 2000"));
    VERIFY(reads(read_202, direction::request, "request to slave 1: read_value 202, PCD 047F 2000"));
    VERIFY(reads(read_621, direction::request, "request to slave 1: text 621 read, PCD 0000 0000"));
    VERIFY(reads("02 06 20 04 3C 00 00 00"_hex, direction::request, "broadcast: PCD 043C 0000"));
}

TEST(text_fc_describe, shows_responses)
{
    VERIFY(reads(process, direction::response, "response from slave 1: PCD 047F 2000"));
    VERIFY(reads(word_202, direction::response, "response from slave 1: word 202 = 1000, PCD 0F03 2000"));
    VERIFY(reads(refused, direction::response,
                 "response from slave 1: cannot_be_executed 202: value_exceeds_limits (2), PCD 0F03 2000"));
    VERIFY(reads(text_621, direction::response, "response from slave 1: text 621 \"VLT 6000\", PCD 0F03 2000"));
}

TEST(text_fc_describe, claims_no_meaning_of_an_ak_whose_direction_is_unknown)
{
    VERIFY(reads(process, direction::unknown, "to or from slave 1: PCD 047F 2000"));
    VERIFY(reads(word_202, direction::unknown, "to or from slave 1: AK 1 202, PWE 000003E8, PCD 0F03 2000"));
    VERIFY(reads(read_202, direction::unknown, "to or from slave 1: AK 1 202, PWE 00000000, PCD 047F 2000"));
    VERIFY(reads(text_621, direction::unknown, "to or from slave 1: text 621 \"VLT 6000\", PCD 0F03 2000"));
}

TEST(text_fc_describe, shows_the_bytes_of_a_length_that_the_layout_does_not_have)
{
    VERIFY(reads(six_bytes, direction::request, "request to slave 1: 6 bytes of data: 01 02 03 04 05 06"));
    VERIFY(reads("02 03 01 AB 00"_hex, direction::unknown, "to or from slave 1: 1 byte of data: AB"));
    VERIFY(reads("02 02 01 01"_hex, direction::unknown, "to or from slave 1: 0 bytes of data"));
}

TEST(text_fc_describe, is_told_the_layout)
{
    using six_words = fc::data_layout<6>;
    VERIFY(reads<six_words>(many_words, direction::request, "request to slave 1: PCD 047F 2000 0001 0002 0003 0004"));
    VERIFY(reads<six_words>(process, direction::request, "request to slave 1: 4 bytes of data: 04 7F 20 00"));
    VERIFY(reads<fc::fc_layout>("02 0E 01 1F A0 00 00 00 00 00 00 00 00 00 00 00"_hex, direction::request,
                                "request to slave 1: read_value 4000, PCD 0000 0000"));
}

TEST(text_fc_describe, marks_what_stood_amid_dropped_bytes)
{
    VERIFY(reads(process, direction::request, "request to slave 1: PCD 047F 2000  (found amid dropped bytes)", false));
}

TEST(text_fc_describe, describes_what_a_reader_gives_without_being_told_a_layout)
{
    fc::reader           reader;
    std::array<char, 60> room;
    EXPECT_TRUE(reader.push("02 06 20 04 3C 00 00 1C"_hex).empty());
    auto const item = reader.next();
    ASSERT_NE(item.frame(), nullptr);
    EXPECT_EQ(describe(*item.frame(), room), "broadcast: PCD 043C 0000");
    EXPECT_EQ(drivecodec::describe(*item.frame(), room), "broadcast: PCD 043C 0000");
    EXPECT_EQ(describe(*item.frame(), std::span{room}.first(10)), "broadca...");
}

/// A telegram of the longest kind, with these data.
std::vector<std::uint8_t> longest(std::vector<std::uint8_t> front)
{
    std::vector<std::uint8_t> made{0x02, 0xFE, 0x56};
    made.insert(made.end(), front.begin(), front.end());
    made.resize(256, 0x01);
    return made;
}

TEST(text_fc_describe, is_never_longer_than_it_says)
{
    for (auto const& raw : {longest({0xF7, 0xFF, 0x07, 0xFF}), longest({0x00})}) {
        for (auto const which : {direction::unknown, direction::request, direction::response}) {
            drivecodec::text_writer text;
            write_text(text, fc::frame{raw, which, false});
            EXPECT_LE(text.needed(), fc::max_description_size);
            EXPECT_GT(text.needed(), 752);
        }
    }
}

}  // namespace
