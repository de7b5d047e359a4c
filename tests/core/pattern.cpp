#include <drivecodec/core/pattern.hpp>

#include "support/verify.hpp"

#include <array>
#include <string_view>

namespace {

using drivecodec::pattern;
using drivecodec::pattern_8;

TEST(pattern, is_written_as_the_standards_write_it)
{
    constexpr pattern_8 coding = "x01x 0001";
    VERIFY(coding.mask == 0b0110'1111);
    VERIFY(coding.value == 0b0010'0001);

    constexpr pattern status = "xxxx xxxx x01x 0111";
    VERIFY(status.mask == 0x006F);
    VERIFY(status.value == 0x0027);
}

TEST(pattern, ignores_blanks)
{
    constexpr pattern_8 dense  = "x01x0001";
    constexpr pattern_8 spaced = " x 0 1 x  0001 ";
    VERIFY(dense.mask == spaced.mask);
    VERIFY(dense.value == spaced.value);
}

TEST(pattern, matches_what_the_letters_say)
{
    constexpr std::string_view letters = "x01x0001";
    constexpr pattern_8        coding  = "x01x 0001";
    for (unsigned byte = 0; byte <= 0xFF; ++byte) {
        bool expected = true;
        for (std::size_t i = 0; i < 8; ++i) {
            auto const bit = (byte >> (7 - i)) & 1U;
            if (letters[i] != 'x' and letters[i] - '0' != static_cast<int>(bit)) { expected = false; }
        }
        ASSERT_EQ(coding.matches(static_cast<std::uint8_t>(byte)), expected) << byte;
    }
    VERIFY(coding.matches(0x21) and coding.matches(0xB1) and not coding.matches(0x20));
}

TEST(pattern, of_x_alone_matches_everything)
{
    constexpr pattern every = "xxxx xxxx xxxx xxxx";
    constexpr pattern zero  = "0000 0000 0000 0000";
    VERIFY(every.matches(0xFFFF) and every.matches(0x0000));
    VERIFY(zero.matches(0x0000) and not zero.matches(0x8000) and not zero.matches(0x0001));
}

TEST(pattern, overlaps_another_where_a_word_matches_both)
{
    constexpr std::array<pattern_8, 6> patterns{pattern_8{"x01x 0001"}, pattern_8{"x01x 0011"}, pattern_8{"xxxx xxxx"},
                                                pattern_8{"0000 0000"}, pattern_8{"1xxx xxxx"}, pattern_8{"xxxx xxx1"}};
    for (auto const a : patterns) {
        for (auto const b : patterns) {
            bool found = false;
            for (unsigned byte = 0; byte <= 0xFF and not found; ++byte) {
                auto const word = static_cast<std::uint8_t>(byte);
                found           = a.matches(word) and b.matches(word);
            }
            ASSERT_EQ(overlap(a, b), found);
        }
    }
    VERIFY(not overlap(patterns[0], patterns[1]));
    VERIFY(overlap(patterns[4], patterns[5]));
}

}  // namespace
