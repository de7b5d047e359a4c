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
