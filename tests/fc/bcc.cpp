#include <drivecodec/fc/bcc.hpp>

#include "support/fc_model.hpp"
#include "support/fc_vectors.hpp"
#include "support/verify.hpp"

#include <random>

namespace {

using drivecodec::bytes;
using drivecodec::fc::bcc;
using fc_model::byte_list;

// VLT 6000 manual, "Data control byte (BCC)". Its example calls the sum BCS in one line and BCC in the next, and has
// binary numbers of seven digits: 0000 0000 before the first byte, 02h after the byte 02h, then D4h after the byte D6h.
TEST(bcc, is_the_one_of_the_example_which_calls_it_bcs_and_bcc_in_turn)
{
    VERIFY(bcc{}.value() == 0);
    VERIFY(bcc{}.add(std::uint8_t{0x02}).value() == 0x02);
    VERIFY(bcc{}.add(std::uint8_t{0x02}).add(std::uint8_t{0xD6}).value() == 0xD4);
    static constexpr auto both = "02 D6"_hex;
    VERIFY(bcc::of(both) == 0xD4);
}

TEST(bcc, begins_at_stx_and_ends_before_itself)
{
    for (auto const telegram : vectors::all_fc) {
        EXPECT_EQ(bcc::of(telegram.first(telegram.size() - 1)), telegram.back());
        EXPECT_NE(bcc::of(telegram.subspan(1, telegram.size() - 2)), telegram.back()) << "without STX";
    }
}

TEST(bcc, of_a_whole_telegram_is_0)
{
    for (auto const telegram : vectors::all_fc) { EXPECT_EQ(bcc::of(telegram), 0); }
    VERIFY(bcc::of(vectors::write_202) == 0);
    VERIFY(bcc::of(vectors::read_621_response) == 0);
}

TEST(bcc, of_any_length_is_that_of_byte_after_byte)
{
    std::mt19937 random{1};
    for (std::size_t size = 0; size <= 300; ++size) {
        byte_list list(size);
        for (auto& byte : list) { byte = static_cast<std::uint8_t>(random()); }
        auto const wanted = fc_model::bcc(list);
        ASSERT_EQ(bcc::of(opaque(bytes{list})), wanted) << size;

        bcc single;
        for (auto const byte : list) { single.add(byte); }
        ASSERT_EQ(single.value(), wanted) << size;

        auto const cut = size == 0 ? 0 : random() % size;
        bcc        parts;
        parts.add(bytes{list}.first(cut)).add(bytes{list}.subspan(cut));
        ASSERT_EQ(parts.value(), wanted) << size << " cut at " << cut;
    }
}

TEST(bcc, does_not_depend_on_where_the_bytes_lie)
{
    byte_list list(64);
    for (std::size_t i = 0; i < list.size(); ++i) { list[i] = static_cast<std::uint8_t>(37 * i + 11); }
    for (std::size_t from = 0; from < 16; ++from) {
        for (std::size_t size = 0; from + size <= list.size(); ++size) {
            auto const part = bytes{list}.subspan(from, size);
            ASSERT_EQ(bcc::of(opaque(part)), fc_model::bcc(part)) << from << ' ' << size;
        }
    }
}

TEST(bcc, sees_an_odd_number_of_errors_in_a_column)
{
    constexpr auto whole = "02 06 16 04 7F 20 00 49"_hex;
    for (unsigned wrong = 1; wrong < 256; ++wrong) {  // bit i: byte i is wrong in column 5
        auto damaged = whole;
        int  count   = 0;
        for (std::size_t i = 0; i < damaged.size(); ++i) {
            if ((wrong >> i) % 2 == 0) { continue; }
            damaged[i] ^= 0x20;
            ++count;
        }
        EXPECT_EQ(bcc::of(damaged) != 0, count % 2 == 1) << wrong;
    }
}

TEST(bcc, does_not_see_bytes_that_changed_places)
{
    static constexpr auto one   = "02 06 16 04 7F 20 00 49"_hex;
    static constexpr auto other = "02 06 16 20 00 04 7F 49"_hex;
    VERIFY(bcc::of(one) == 0 and bcc::of(other) == 0);
}

}  // namespace
