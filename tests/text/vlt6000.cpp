#include <drivecodec/text/vlt6000.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec;

TEST(text_vlt6000_umbrella, describes_words_and_parameters)
{
    std::array<char, 100> room{};
    EXPECT_EQ(describe(vlt6000::control_word::from_raw(0x047F), room), "CTW 047F start preset_reference_4 setup_1");
    EXPECT_EQ(describe(vlt6000::parameter_value{202, 1000}, room), "202 output_frequency_high_limit 100.0 Hz");
    EXPECT_EQ(to_string(vlt6000::gating::logic_or), "logic_or");
}

}  // namespace
