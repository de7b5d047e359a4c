#include <drivecodec/text/cia402/option_code.hpp>

#include "support/verify.hpp"

#include <string>

namespace {

using namespace drivecodec::cia402;

/// Every code that has a name, in order: "0 disable_drive, 1 ..."
template <typename Option>
std::string all_names()
{
    std::string names;
    for (int code = -0x8000; code <= 0x7FFF; ++code) {
        auto const name = to_string(static_cast<Option>(code));
        if (name.empty()) { continue; }
        names += names.empty() ? "" : ", ";
        names += std::to_string(code) + " " + std::string{name};
    }
    return names;
}

// IEC 61800-7-201, objects 605Ah to 605Eh.
TEST(text_cia402, has_a_name_for_every_option_code)
{
    EXPECT_EQ(all_names<quick_stop_option>(),
              "0 disable_drive, 1 slow_down_ramp, 2 quick_stop_ramp, 3 current_limit, 4 voltage_limit, "
              "5 slow_down_ramp_and_stay, 6 quick_stop_ramp_and_stay, 7 current_limit_and_stay, "
              "8 voltage_limit_and_stay");
    EXPECT_EQ(all_names<shutdown_option>(), "0 disable_drive, 1 slow_down_ramp");
    EXPECT_EQ(all_names<disable_operation_option>(), "0 disable_drive, 1 slow_down_ramp");
    EXPECT_EQ(all_names<halt_option>(), "1 slow_down_ramp, 2 quick_stop_ramp, 3 current_limit, 4 voltage_limit");
    EXPECT_EQ(all_names<fault_reaction_option>(),
              "0 disable_drive, 1 slow_down_ramp, 2 quick_stop_ramp, 3 current_limit, 4 voltage_limit");
    VERIFY(to_string(quick_stop_option{6}) == "quick_stop_ramp_and_stay" and to_string(quick_stop_option{-1}).empty());
}

}  // namespace
