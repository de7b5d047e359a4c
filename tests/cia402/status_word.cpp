#include <drivecodec/cia402/status_word.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using drivecodec::cia402::status_word;

// IEC 61800-7-201, "Statusword": each bit.
static_assert(status_word::of(status_word::ready_to_switch_on).raw == 0x0001);
static_assert(status_word::of(status_word::switched_on).raw == 0x0002);
static_assert(status_word::of(status_word::operation_enabled).raw == 0x0004);
static_assert(status_word::of(status_word::fault).raw == 0x0008);
static_assert(status_word::of(status_word::voltage_enabled).raw == 0x0010);
static_assert(status_word::of(status_word::no_quick_stop).raw == 0x0020);
static_assert(status_word::of(status_word::switch_on_disabled).raw == 0x0040);
static_assert(status_word::of(status_word::warning).raw == 0x0080);
static_assert(status_word::of(status_word::manufacturer_specific_8).raw == 0x0100);
static_assert(status_word::of(status_word::remote).raw == 0x0200);
static_assert(status_word::of(status_word::target_reached).raw == 0x0400);
static_assert(status_word::of(status_word::internal_limit_active).raw == 0x0800);
static_assert(status_word::of(status_word::mode_specific_12).raw == 0x1000);
static_assert(status_word::of(status_word::mode_specific_13).raw == 0x2000);
static_assert(status_word::of(status_word::manufacturer_specific_14).raw == 0x4000);
static_assert(status_word::of(status_word::manufacturer_specific_15).raw == 0x8000);

TEST(status_word, keeps_every_bit_that_it_is_given)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = status_word::from_raw(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(word.with(status_word::warning).without(status_word::warning).raw, raw & ~0x0080U);
        ASSERT_EQ(word.test(status_word::remote), (raw >> 9 & 1U) != 0);
    }
}

}  // namespace
