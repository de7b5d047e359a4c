#include <drivecodec/drives/smd/fault.hpp>
#include <drivecodec/drives/smd/hardware.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::smd::hardware;

// smd manual, table 9: each bit.
static_assert(hardware::of(hardware::reserved_0).raw == 0x0001);
static_assert(hardware::of(hardware::reserved_1).raw == 0x0002);
static_assert(hardware::of(hardware::oem_defaults_present).raw == 0x0004);
static_assert(hardware::of(hardware::user_data_compatible_only).raw == 0x0008);

TEST(smd_hardware, has_two_bits_and_keeps_all_others)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const found = hardware::from_raw(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(found.raw, raw);
        ASSERT_EQ(found.test(hardware::oem_defaults_present), raw / 4 % 2 == 1);
        ASSERT_EQ(found.test(hardware::user_data_compatible_only), raw / 8 % 2 == 1);
    }
}

TEST(smd_manual, tells_a_matching_from_an_incompatible_memory_module_by_a_fault_only)
{
    // Bit 3 is 0 for both; of the three faults it names, two have a code.
    using drivecodec::smd::fault;
    VERIFY(not hardware::from_raw(0).test(hardware::user_data_compatible_only));
    VERIFY(fault{6} == fault::control_fault and fault{21} == fault::incompatibility_fault);
}

}  // namespace
