#include <drivecodec/text/drives/vlt6000/digital_inputs.hpp>

#include <drivecodec/text/core.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using drivecodec::vlt6000::digital_inputs;

constexpr bool reads(std::uint16_t raw, std::string_view expected)
{
    std::array<char, 80> room{};
    return drivecodec::describe(digital_inputs::from_raw(raw), room) == expected;
}

TEST(text_vlt6000_digital_inputs, terminal_16_is_to_the_extreme_left)
{
    VERIFY(reads(0x00, "00000000"));
    VERIFY(reads(0x80, "10000000 16"));
    VERIFY(reads(0x01, "00000001 33"));
    VERIFY(reads(0x28, "00101000 18 27"));
    VERIFY(reads(0xFF, "11111111 16 17 18 19 27 29 32 33"));
    VERIFY(reads(0x0108, "00001000 27 +0100"));
}

}  // namespace
