#include <drivecodec/text/modbus/exception_code.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using drivecodec::modbus::exception_code;

TEST(text_exception_code, has_a_name_for_all_nine)
{
    EXPECT_EQ(names_of_all_values<exception_code>().size(), 9);
    VERIFY(to_string(exception_code::illegal_function) == "illegal_function");
    VERIFY(to_string(exception_code::gateway_target_device_failed_to_respond)
           == "gateway_target_device_failed_to_respond");
    VERIFY(to_string(static_cast<exception_code>(7)).empty());
    VERIFY(to_string(static_cast<exception_code>(9)).empty());
}

}  // namespace
