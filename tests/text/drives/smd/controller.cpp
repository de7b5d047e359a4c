#include <drivecodec/text/drives/smd/controller.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec::smd;

TEST(text_smd_controller, has_a_name_for_everything_that_it_says)
{
    EXPECT_EQ(names_of_all_values<progress>().size(), 4);
    EXPECT_EQ(names_of_all_values<refusal>().size(), 13);
    EXPECT_EQ(names_of_all_values<step>().size(), 9);
    EXPECT_EQ(names_of_all_values<lock_state>().size(), 4);
    EXPECT_EQ(names_of_all_values<time_out_reaction>().size(), 5);
    VERIFY(to_string(progress::waiting) == "waiting");
    VERIFY(to_string(refusal::no_serial_control) == "no_serial_control");
    VERIFY(to_string(step::set_reference) == "set_reference");
    VERIFY(to_string(lock_state::parameters) == "parameters");
    VERIFY(to_string(time_out_reaction::lock_and_trip) == "lock_and_trip");
}

TEST(text_smd_controller, names_the_exceptions_of_the_manual_and_no_other)
{
    for (unsigned number = 0; number <= 0xFF; ++number) {
        auto const is_named = (number >= 1 and number <= 4) or number == 6;
        EXPECT_EQ(not to_string(exception{static_cast<std::uint8_t>(number)}).empty(), is_named) << number;
    }
    VERIFY(to_string(exception{4}) == "wrong_data_format");
}

TEST(text_smd_controller, explains_every_refusal)
{
    for (unsigned number = 0; number <= 0xFF; ++number) {
        auto const why = refusal{static_cast<std::uint8_t>(number)};
        EXPECT_EQ(not explain(why).empty(), number != 0 and not to_string(why).empty()) << number;
    }
    VERIFY(explain(refusal::inhibited) == "the drive is inhibited: close terminal 28");
}

}  // namespace
