#include <drivecodec/text/modbus/diagnostic.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using drivecodec::modbus::diagnostic;

TEST(text_diagnostic, has_a_name_for_every_sub_function)
{
    EXPECT_EQ(names_of_all_values<diagnostic>().size(), 15);
    VERIFY(to_string(diagnostic::return_query_data) == "return_query_data");
    VERIFY(to_string(diagnostic::clear_overrun_counter_and_flag) == "clear_overrun_counter_and_flag");
    VERIFY(to_string(static_cast<diagnostic>(19)).empty());
    VERIFY(to_string(static_cast<diagnostic>(0x0100)).empty());
}

}  // namespace
