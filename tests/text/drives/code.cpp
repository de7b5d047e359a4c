#include <drivecodec/text/drives/code.hpp>
#include <drivecodec/text/drives/direction.hpp>

#include "support/verify.hpp"

#include <array>
#include <string>

namespace {

using namespace drivecodec;
using drives::direction;

std::string text_of(direction code)
{
    std::array<char, 20> room{};
    text_writer          out{room};
    drives::write_code(out, code);
    return std::string{out.view()};
}

TEST(text_code, is_a_name_or_else_a_number)
{
    EXPECT_EQ(text_of(direction::reverse), "reverse");
    EXPECT_EQ(text_of(direction{2}), "2");
    EXPECT_EQ(text_of(direction{255}), "255");
}

}  // namespace

namespace somebodys {

struct lamp {
    bool is_on;
};
constexpr void write_text(drivecodec::text_writer& out, lamp given) noexcept
{
    out.put(given.is_on ? "on" : "off");
}

}  // namespace somebodys

namespace {

template <typename Value>
std::string meaning_of(Value const& value)
{
    std::array<char, 20> room{};
    text_writer          out{room};
    drives::write_meaning(out, value);
    return std::string{out.view()};
}

TEST(text_meaning, is_in_the_words_of_the_type_or_else_a_name_or_a_number)
{
    EXPECT_EQ(meaning_of(somebodys::lamp{true}), "on");
    EXPECT_EQ(meaning_of(somebodys::lamp{false}), "off");
    EXPECT_EQ(meaning_of(direction::forward), "forward");
    EXPECT_EQ(meaning_of(direction{7}), "7");
}

}  // namespace
