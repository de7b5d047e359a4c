#include <drivecodec/text/smd.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec;

TEST(text_smd_umbrella, describes_parameters_faults_and_progress)
{
    std::array<char, 100> room{};
    EXPECT_EQ(describe(smd::register_value{smd::pv507, 61, 50}, room), "C12 acceleration_time 5.0 s");
    EXPECT_EQ(to_string(smd::progress::reached), "reached");
    EXPECT_EQ(to_string(smd::command::start), "start");
}

}  // namespace
