#include <drivecodec/fc/text.hpp>

#include "support/fc_model.hpp"
#include "support/hex.hpp"
#include "support/verify.hpp"

#include <random>

namespace {

using namespace drivecodec::literals;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using drivecodec::same_bytes;
using namespace drivecodec::fc;
using fc_model::byte_list;

// "VLT6000", the reply to a read of 621.
constexpr auto seven_characters = "F2 6D 04 00 56 4C 54 36 30 30 30 0F 03 20 00"_hex;

TEST(text, decodes_its_characters)
{
    static constexpr auto read = drivecodec::decode<text_response>(seven_characters);
    VERIFY(read->number() == 621);
    VERIFY(read->access() == text_access::read);
    VERIFY(same_bytes(read->characters, "56 4C 54 36 30 30 30"_hex));
    VERIFY(read->process.status_word() == 0x0F03);
    VERIFY(read->wire_size() == 15);
}

TEST(text, points_into_the_wire)
{
    auto const read = drivecodec::decode<text_response>(seven_characters);
    EXPECT_EQ(read->characters.data(), seven_characters.data() + 4);
}

TEST(text, may_have_no_characters)
{
    static constexpr auto none = "F2 6D 04 00 01 02 03 04"_hex;
    static constexpr auto read = drivecodec::decode<text_request>(none);
    VERIFY(read->characters.empty());
    VERIFY(read->process.control_word() == 0x0102);
}

TEST(text, has_at_most_244_characters)
{
    VERIFY(max_text_size<> == 244);  // LGE 254 = 10 + 244
    VERIFY(max_text_size<fc_layout> == 244);
    VERIFY(max_text_size<data_layout<4>> == 240);
    VERIFY(max_text_size<data_layout<16>> == 216);
}

template <typename Data>
void survives_with_every_size()
{
    using layout = typename Data::layout_type;
    std::mt19937 random{5};
    for (std::size_t size = 0; size <= 300; ++size) {
        byte_list wire(size);
        for (auto& byte : wire) { byte = static_cast<std::uint8_t>(random()); }
        if (size < layout::around_text) {
            ASSERT_EQ(Data::check(wire), error(errc::truncated, layout::around_text)) << size;
            continue;
        }
        wire[0] |= 0xF0;
        auto const read = drivecodec::decode<Data>(bytes{wire});
        ASSERT_TRUE(read) << size;
        ASSERT_EQ(read->characters.size(), size - layout::around_text);
        ASSERT_EQ(read->wire_size(), size);
        ASSERT_EQ(read->pke.raw, wire[0] * 256 + wire[1]);
        ASSERT_EQ(static_cast<unsigned>(read->access()), wire[2]);
        ASSERT_EQ(read->process.pcd(0),
                  wire[size - layout::process_size] * 256 + wire[size - layout::process_size + 1]);

        byte_list again(size);
        ASSERT_TRUE(drivecodec::encode(*read, again));
        ASSERT_EQ(again, wire);

        wire[0] &= 0x7F;
        ASSERT_EQ(Data::check(wire), error(errc::unexpected_function, 0)) << size;
    }
}

TEST(text, survives_with_every_size_in_both_directions_and_all_layouts)
{
    survives_with_every_size<text_request>();
    survives_with_every_size<text_response>();
    survives_with_every_size<basic_text_response<fc_layout>>();
    survives_with_every_size<basic_text_request<data_layout<4, 12>>>();
    survives_with_every_size<basic_text_response<data_layout<8>>>();
}

TEST(text, has_ak_f_and_no_other)
{
    for (unsigned ak = 0; ak < 16; ++ak) {
        auto wire        = seven_characters;
        wire[0]          = static_cast<std::uint8_t>(ak << 4 | 2);
        auto const fault = text_response::check(wire);
        EXPECT_EQ(fault, ak == 0xF ? error{} : error(errc::unexpected_function, 0)) << ak;
    }
}

TEST(text, is_compared_by_its_characters_not_by_where_they_lie)
{
    auto const copy  = byte_list{seven_characters.begin(), seven_characters.end()};
    auto const one   = *drivecodec::decode<text_response>(seven_characters);
    auto const other = *drivecodec::decode<text_response>(bytes{copy});
    EXPECT_EQ(one, other);
    for (std::size_t at = 0; at < copy.size(); ++at) {
        auto damaged = copy;
        damaged[at] ^= 0x01;
        EXPECT_FALSE(one == *drivecodec::decode<text_response>(bytes{damaged})) << at;
    }
}

TEST(text, of_its_own_has_a_size_that_the_compiler_knows)
{
    using five = basic_fixed_text_request<vlt_layout, 5>;
    VERIFY(five::wire_size() == 13 and five::has_own_text and five::is_request);
    static constexpr five hello{
        pke::from_raw(0xF215), ind::from_raw(0x0500), {'H', 'E', 'L', 'L', 'O'}, data_valid(0x047F, 50_percent)};
    VERIFY(drivecodec::encode(hello) == "F2 15 05 00 48 45 4C 4C 4F 04 7F 20 00"_hex);
    VERIFY(not text_request::has_own_text and text_request::is_request and not text_response::is_request);
}

}  // namespace
