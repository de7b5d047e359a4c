#include <drivecodec/cia402/mode_specific.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::cia402;
using drivecodec::errc;

// IEC 61800-7-201, "Use of controlword and statusword" of each mode.
static_assert(control_word::of(profile_position::new_set_point).raw == 0x0010);
static_assert(control_word::of(profile_position::change_set_immediately).raw == 0x0020);
static_assert(control_word::of(profile_position::relative).raw == 0x0040);
static_assert(control_word::of(profile_position::change_on_set_point).raw == 0x0200);
static_assert(status_word::of(profile_position::target_reached).raw == 0x0400);
static_assert(status_word::of(profile_position::set_point_acknowledge).raw == 0x1000);
static_assert(status_word::of(profile_position::following_error).raw == 0x2000);
static_assert(control_word::of(velocity::enable_ramp).raw == 0x0010);
static_assert(control_word::of(velocity::unlock_ramp).raw == 0x0020);
static_assert(control_word::of(velocity::reference_ramp).raw == 0x0040);
static_assert(status_word::of(profile_velocity::target_reached).raw == 0x0400);
static_assert(status_word::of(profile_velocity::speed_is_zero).raw == 0x1000);
static_assert(status_word::of(profile_velocity::maximum_slippage_error).raw == 0x2000);
static_assert(status_word::of(profile_torque::target_reached).raw == 0x0400);
static_assert(control_word::of(homing::start).raw == 0x0010);
static_assert(status_word::of(homing::target_reached).raw == 0x0400);
static_assert(status_word::of(homing::attained).raw == 0x1000);
static_assert(status_word::of(homing::error).raw == 0x2000);
static_assert(control_word::of(interpolated_position::enable_interpolation).raw == 0x0010);
static_assert(status_word::of(interpolated_position::target_reached).raw == 0x0400);
static_assert(status_word::of(interpolated_position::active).raw == 0x1000);
static_assert(status_word::of(cyclic_synchronous_position::follows_command).raw == 0x1000);
static_assert(status_word::of(cyclic_synchronous_position::following_error).raw == 0x2000);
static_assert(status_word::of(cyclic_synchronous_velocity::follows_command).raw == 0x1000);
static_assert(status_word::of(cyclic_synchronous_torque::follows_command).raw == 0x1000);

constexpr status_word word_of(unsigned raw)
{
    return status_word::from_raw(static_cast<std::uint16_t>(raw));
}

TEST(homing, progress_is_in_bits_13_12_and_10)
{
    using enum homing::progress;
    VERIFY(*homing::decode_progress(word_of(0x0000)) == in_progress);
    VERIFY(*homing::decode_progress(word_of(0x0400)) == interrupted_or_not_started);
    VERIFY(*homing::decode_progress(word_of(0x1000)) == attained_but_target_not_reached);
    VERIFY(*homing::decode_progress(word_of(0x1400)) == completed);
    VERIFY(*homing::decode_progress(word_of(0x2000)) == error_while_moving);
    VERIFY(*homing::decode_progress(word_of(0x2400)) == error_at_standstill);
    VERIFY(homing::decode_progress(word_of(0x3000)).error().code() == errc::bad_value);
    VERIFY(homing::decode_progress(word_of(0x3400)).error().code() == errc::bad_value);
}

TEST(homing, progress_does_not_depend_on_any_other_bit)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        ASSERT_EQ(homing::decode_progress(word_of(raw)), homing::decode_progress(word_of(raw & 0x3400U))) << raw;
    }
}

}  // namespace
