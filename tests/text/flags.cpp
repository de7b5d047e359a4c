#include <drivecodec/text/flags.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;

struct lamp_word : word<lamp_word, std::uint16_t> {
    static constexpr flag<lamp_word> red{0};
    static constexpr flag<lamp_word> green{9};
};
constexpr std::array<flag_name<lamp_word>, 2> names{{{lamp_word::green, "green"}, {lamp_word::red, "red"}}};

constexpr bool reads(std::uint16_t raw, std::string_view expected)
{
    std::array<char, 40> room{};
    text_writer          out{room};
    write_flags(out, lamp_word::from_raw(raw), names);
    return out.view() == expected;
}

TEST(text_flags, names_what_is_1_in_the_order_of_the_names)
{
    VERIFY(reads(0x0000, ""));
    VERIFY(reads(0x0001, " red"));
    VERIFY(reads(0x0200, " green"));
    VERIFY(reads(0x0201, " green red"));
}

TEST(text_flags, bits_without_a_name_are_not_lost)
{
    VERIFY(reads(0x8000, " +8000"));
    VERIFY(reads(0xFFFF, " green red +FDFE"));
}

}  // namespace
