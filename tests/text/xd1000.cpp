#include <drivecodec/text/xd1000.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec;

TEST(text_xd1000_umbrella, describes_words_registers_and_the_identification)
{
    std::array<char, 100> room{};
    EXPECT_EQ(describe(xd1000::command_word{cia402::command::shutdown}, room), "CMD 0006 shutdown");
    EXPECT_EQ(describe(xd1000::register_value{3104, 500}, room), "high_speed 50.0 Hz");
    EXPECT_EQ(describe(xd1000::version{2, 1}, room), "2.1");
    EXPECT_EQ(to_string(xd1000::baud_rate::baud_9600), "baud_9600");
}

}  // namespace
