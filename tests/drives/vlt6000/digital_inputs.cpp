#include <drivecodec/drives/vlt6000/digital_inputs.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec;
using vlt6000::digital_inputs;

/// From left to right, as the manual lists them: "(16, 17, 18, 19, 27, 29, 32 and 33)".
constexpr std::array left_to_right{
    digital_inputs::terminal_16, digital_inputs::terminal_17, digital_inputs::terminal_18, digital_inputs::terminal_19,
    digital_inputs::terminal_27, digital_inputs::terminal_29, digital_inputs::terminal_32, digital_inputs::terminal_33};

TEST(vlt6000_digital_inputs, are_eight_bits_with_input_16_to_the_extreme_left)
{
    VERIFY(digital_inputs::of(digital_inputs::terminal_16).raw == 0b1000'0000);
    VERIFY(digital_inputs::of(digital_inputs::terminal_17).raw == 0b0100'0000);
    VERIFY(digital_inputs::of(digital_inputs::terminal_18).raw == 0b0010'0000);
    VERIFY(digital_inputs::of(digital_inputs::terminal_19).raw == 0b0001'0000);
    VERIFY(digital_inputs::of(digital_inputs::terminal_27).raw == 0b0000'1000);
    VERIFY(digital_inputs::of(digital_inputs::terminal_29).raw == 0b0000'0100);
    VERIFY(digital_inputs::of(digital_inputs::terminal_32).raw == 0b0000'0010);
    VERIFY(digital_inputs::of(digital_inputs::terminal_33).raw == 0b0000'0001);
}

TEST(vlt6000_digital_inputs, read_as_the_display_shows_them)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const inputs = digital_inputs::from_raw(static_cast<std::uint16_t>(raw));
        auto       shown  = 0U;
        for (auto const input : left_to_right) { shown = 2 * shown + (inputs.test(input) ? 1U : 0U); }
        ASSERT_EQ(shown, raw % 256);
        ASSERT_EQ(inputs.raw, raw);  // the manual does not say that the others are 0
    }
}

}  // namespace
