#include <drivecodec/drives/smd/operational_status.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using status = drivecodec::smd::operational_status;

/// smd manual, tables 11 and 20, from the first row on.
constexpr std::array printed{status::fault_lockout, status::fault,          status::start_pending,
                             status::stop,          status::dc_brake,       status::run_at_0_hz,
                             status::run,           status::accel,          status::decel,
                             status::current_limit, status::decel_override, status::lower_transistors_switching_on,
                             status::off,           status::inhibit};

TEST(smd_manual, heads_the_operational_status_bit_with_fourteen_rows_for_one_byte)
{
    // So it is a number: rows 8 to 13 are no bits of a byte, yet all fourteen are values of one.
    VERIFY(sizeof(status) == 1 and printed.size() == 14);
    for (std::size_t row = 0; row < printed.size(); ++row) { EXPECT_EQ(static_cast<std::size_t>(printed[row]), row); }
}

}  // namespace
