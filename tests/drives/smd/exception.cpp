#include <drivecodec/drives/smd/exception.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using smd::to_exception;

// smd manual, section 2.3, E: the numbers of Modbus, and not all of its meanings.
TEST(smd_exception, has_the_numbers_of_the_manual)
{
    VERIFY(to_exception(modbus::exception_code{1}) == smd::exception::command_rejected);
    VERIFY(to_exception(modbus::exception_code{2}) == smd::exception::no_such_register);
    VERIFY(to_exception(modbus::exception_code{3}) == smd::exception::data_out_of_range);
    VERIFY(to_exception(modbus::exception_code{6}) == smd::exception::slave_device_busy);
}

TEST(smd_exception, wrong_data_format_has_the_number_that_modbus_calls_server_device_failure)
{
    VERIFY(to_exception(modbus::exception_code::server_device_failure) == smd::exception::wrong_data_format);
}

TEST(smd_exception, stays_the_number_that_it_is)
{
    for (unsigned number = 0; number <= 0xFF; ++number) {
        auto const code = to_exception(modbus::exception_code{static_cast<std::uint8_t>(number)});
        EXPECT_EQ(static_cast<unsigned>(code), number);
    }
}

}  // namespace
