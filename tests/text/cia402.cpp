#include <drivecodec/text/cia402.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::cia402;

TEST(text_cia402, umbrella_has_all_of_it)
{
    std::array<char, 40>    room{};
    drivecodec::text_writer out;
    write_state_diagram(out);
    EXPECT_GT(out.needed(), 1000U);
    EXPECT_EQ(describe(control_word{}, room), "0000 disable_voltage");
    VERIFY(to_string(state::fault) == "fault");
}

}  // namespace
