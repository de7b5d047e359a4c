#include <drivecodec/text/fc/parameter_error.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

#include <array>

namespace {

using drivecodec::describe;
using drivecodec::errc;
using drivecodec::error;
using drivecodec::fc::parameter_error;
using drivecodec::fc::reply_error;

constexpr bool reads(auto const& thing, std::string_view expected)
{
    std::array<char, 100> room{};
    return describe(thing, room) == expected;
}

TEST(text_parameter_error, has_a_name_for_every_number_of_the_manual_and_of_newer_guides)
{
    EXPECT_EQ(names_of_all_values<parameter_error>().size(), 9U + 11U);
    VERIFY(to_string(parameter_error{0}) == "parameter_does_not_exist");
    VERIFY(to_string(parameter_error{1}) == "no_write_access");
    VERIFY(to_string(parameter_error{2}) == "value_exceeds_limits");
    VERIFY(to_string(parameter_error{3}) == "sub_index_does_not_exist");
    VERIFY(to_string(parameter_error{4}) == "not_an_array");
    VERIFY(to_string(parameter_error{5}) == "data_type_does_not_match");
    VERIFY(to_string(parameter_error{17}) == "not_possible_in_present_mode");
    VERIFY(to_string(parameter_error{130}) == "no_bus_access");
    VERIFY(to_string(parameter_error{131}) == "factory_setup_selected");
    VERIFY(to_string(parameter_error{6}) == "only_reset");
    VERIFY(to_string(parameter_error{7}) == "not_changeable");
    VERIFY(to_string(parameter_error{9}) == "no_description");
    VERIFY(to_string(parameter_error{11}) == "no_parameter_write_access");
    VERIFY(to_string(parameter_error{15}) == "no_text");
    VERIFY(to_string(parameter_error{18}) == "other_error");
    VERIFY(to_string(parameter_error{132}) == "no_lcp_access");
    VERIFY(to_string(parameter_error{252}) == "unknown_viewer");
    VERIFY(to_string(parameter_error{253}) == "request_not_supported");
    VERIFY(to_string(parameter_error{254}) == "unknown_attribute");
    VERIFY(to_string(parameter_error{255}) == "no_error");
}

TEST(text_parameter_error, is_explained_where_it_has_a_name)
{
    std::set<std::string_view> sentences;
    for (std::uint32_t number = 0; number <= 0xFFFF; ++number) {
        auto const which = static_cast<parameter_error>(number);
        EXPECT_EQ(explain(which).empty(), to_string(which).empty()) << number;
        if (not explain(which).empty()) { EXPECT_TRUE(sentences.insert(explain(which)).second) << explain(which); }
    }
    VERIFY(explain(parameter_error::value_exceeds_limits) == "the value is outside the limits of the parameter");
}

TEST(text_parameter_error, is_written_with_its_number)
{
    VERIFY(reads(parameter_error::parameter_does_not_exist, "parameter_does_not_exist (0)"));
    VERIFY(reads(parameter_error::value_exceeds_limits, "value_exceeds_limits (2)"));
    VERIFY(reads(parameter_error::factory_setup_selected, "factory_setup_selected (131)"));
    VERIFY(reads(parameter_error{100}, "error 100"));
    VERIFY(reads(parameter_error{0xFFFF}, "error 65535"));
}

TEST(text_reply_error, names_a_refusal_and_places_everything_else)
{
    VERIFY(reads(reply_error{parameter_error::no_bus_access}, "exception_reply no_bus_access (130)"));
    VERIFY(reads(reply_error{parameter_error{1000}}, "exception_reply error 1000"));
    VERIFY(reads(reply_error{error{errc::unexpected_server, 2}}, "unexpected_server at byte 2"));
    VERIFY(reads(reply_error{error{errc::truncated, 16}}, "truncated, 16 bytes needed"));
}

}  // namespace
