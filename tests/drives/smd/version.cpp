#include <drivecodec/drives/smd/version.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;

TEST(smd_version, is_400_or_507_and_no_other_number)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const made = smd::make_version(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(made.has_value(), raw == 400 or raw == 507) << raw;
        if (not made) { ASSERT_EQ(made.error(), (error{errc::bad_value, 0})); }
    }
    VERIFY(*smd::make_version(400) == smd::pv400 and *smd::make_version(507) == smd::pv507);
}

TEST(smd_manual, calls_the_number_in_register_50_parameter_configuration_PC_and_PV)
{
    VERIFY(static_cast<unsigned>(smd::pv400) == 400 and static_cast<unsigned>(smd::pv507) == 507);
}

}  // namespace
