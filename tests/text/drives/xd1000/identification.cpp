#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/xd1000/identification.hpp>

#include "support/verify.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace {

using namespace drivecodec::xd1000;
using drivecodec::describe;

std::vector<std::uint8_t> ascii(std::string_view text)
{
    return {text.begin(), text.end()};
}

TEST(text_xd1000_identification, is_name_reference_and_version)
{
    auto const            vendor    = ascii("Lauritz Knudsen Electrical & Automation");
    auto const            reference = ascii("xD1000H037N4");
    auto const            revision  = ascii("0201");
    std::array<char, 200> room{};
    EXPECT_EQ(describe(identification{vendor, reference, revision}, room),
              R"("Lauritz Knudsen Electrical & Automation" "xD1000H037N4" 2.1)");

    auto const other = ascii("V2");
    EXPECT_EQ(describe(identification{vendor, reference, other}, room),
              R"("Lauritz Knudsen Electrical & Automation" "xD1000H037N4" "V2")");
    EXPECT_EQ(describe(identification{}, room), R"("" "" "")");
}

TEST(text_xd1000_identification, has_a_version_in_two_numbers)
{
    std::array<char, 20> room{};
    EXPECT_EQ(describe(version{2, 1}, room), "2.1");
    EXPECT_EQ(describe(version{12, 34}, room), "12.34");
    EXPECT_EQ(describe(version{0, 0}, room), "0.0");
}

}  // namespace
