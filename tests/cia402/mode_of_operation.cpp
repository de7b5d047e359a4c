#include <drivecodec/cia402/mode_of_operation.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::cia402;

// IEC 61800-7-201, "Modes of operation": the numbers.
static_assert(static_cast<int>(mode_of_operation::none) == 0);
static_assert(static_cast<int>(mode_of_operation::profile_position) == 1);
static_assert(static_cast<int>(mode_of_operation::velocity) == 2);
static_assert(static_cast<int>(mode_of_operation::profile_velocity) == 3);
static_assert(static_cast<int>(mode_of_operation::profile_torque) == 4);
static_assert(static_cast<int>(mode_of_operation::homing) == 6);
static_assert(static_cast<int>(mode_of_operation::interpolated_position) == 7);
static_assert(static_cast<int>(mode_of_operation::cyclic_synchronous_position) == 8);
static_assert(static_cast<int>(mode_of_operation::cyclic_synchronous_velocity) == 9);
static_assert(static_cast<int>(mode_of_operation::cyclic_synchronous_torque) == 10);
static_assert(static_cast<int>(mode_of_operation::cyclic_synchronous_torque_commutation_angle) == 11);

TEST(mode_of_operation, of_a_manufacturer_is_negative)
{
    for (int number = -128; number <= 127; ++number) {
        EXPECT_EQ(is_manufacturer_specific(static_cast<mode_of_operation>(number)), number < 0);
    }
}

TEST(mode_of_operation, is_supported_by_the_bit_of_its_number)
{
    for (int number = -128; number <= 127; ++number) {
        for (unsigned bit = 0; bit < 32; ++bit) {
            auto const wanted = number >= 1 and number <= 16 and bit == static_cast<unsigned>(number - 1);
            ASSERT_EQ(is_supported(1U << bit, static_cast<mode_of_operation>(number)), wanted) << number << ' ' << bit;
        }
    }
    VERIFY(is_supported(0x00000001, mode_of_operation::profile_position));
    VERIFY(not is_supported(0xFFFFFFFF, mode_of_operation::none));
}

}  // namespace
