#include <drivecodec/cia402/control_word.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::cia402::control_word;

// IEC 61800-7-201, "Controlword": each bit.
static_assert(control_word::of(control_word::switch_on).raw == 0x0001);
static_assert(control_word::of(control_word::enable_voltage).raw == 0x0002);
static_assert(control_word::of(control_word::no_quick_stop).raw == 0x0004);
static_assert(control_word::of(control_word::enable_operation).raw == 0x0008);
static_assert(control_word::of(control_word::mode_specific_4).raw == 0x0010);
static_assert(control_word::of(control_word::mode_specific_5).raw == 0x0020);
static_assert(control_word::of(control_word::mode_specific_6).raw == 0x0040);
static_assert(control_word::of(control_word::fault_reset).raw == 0x0080);
static_assert(control_word::of(control_word::halt).raw == 0x0100);
static_assert(control_word::of(control_word::mode_specific_9).raw == 0x0200);
static_assert(control_word::of(control_word::reserved_10).raw == 0x0400);
static_assert(control_word::of(control_word::manufacturer_specific_11).raw == 0x0800);
static_assert(control_word::of(control_word::manufacturer_specific_12).raw == 0x1000);
static_assert(control_word::of(control_word::manufacturer_specific_13).raw == 0x2000);
static_assert(control_word::of(control_word::manufacturer_specific_14).raw == 0x4000);
static_assert(control_word::of(control_word::manufacturer_specific_15).raw == 0x8000);

TEST(control_word, keeps_every_bit_that_it_is_given)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = control_word::from_raw(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(word.without(control_word::halt).with(control_word::halt).raw, raw | 0x0100U);
    }
}

}  // namespace
