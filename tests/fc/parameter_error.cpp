#include <drivecodec/fc/parameter_error.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::errc;
using drivecodec::error;
using drivecodec::fc::parameter_error;
using drivecodec::fc::reply_error;

// VLT 6000 manual, "(reply 0111) Error message".
TEST(parameter_error, has_the_numbers_of_the_manual)
{
    VERIFY(parameter_error{0} == parameter_error::parameter_does_not_exist);
    VERIFY(parameter_error{1} == parameter_error::no_write_access);
    VERIFY(parameter_error{2} == parameter_error::value_exceeds_limits);
    VERIFY(parameter_error{3} == parameter_error::sub_index_does_not_exist);
    VERIFY(parameter_error{4} == parameter_error::not_an_array);
    VERIFY(parameter_error{5} == parameter_error::data_type_does_not_match);
    VERIFY(parameter_error{17} == parameter_error::not_possible_in_present_mode);
    VERIFY(parameter_error{130} == parameter_error::no_bus_access);
    VERIFY(parameter_error{131} == parameter_error::factory_setup_selected);
}

TEST(parameter_error, has_the_numbers_of_newer_guides)
{
    VERIFY(parameter_error{6} == parameter_error::only_reset);
    VERIFY(parameter_error{7} == parameter_error::not_changeable);
    VERIFY(parameter_error{9} == parameter_error::no_description);
    VERIFY(parameter_error{11} == parameter_error::no_parameter_write_access);
    VERIFY(parameter_error{15} == parameter_error::no_text);
    VERIFY(parameter_error{18} == parameter_error::other_error);
    VERIFY(parameter_error{132} == parameter_error::no_lcp_access);
    VERIFY(parameter_error{252} == parameter_error::unknown_viewer);
    VERIFY(parameter_error{253} == parameter_error::request_not_supported);
    VERIFY(parameter_error{254} == parameter_error::unknown_attribute);
    VERIFY(parameter_error{255} == parameter_error::no_error);
}

TEST(reply_error, keeps_every_number)
{
    for (unsigned number = 0; number <= 0xFFFF; ++number) {
        auto const refusal = reply_error{static_cast<parameter_error>(number)};
        ASSERT_EQ(refusal.code(), errc::exception_reply);
        ASSERT_EQ(static_cast<unsigned>(refusal.number()), number);
        ASSERT_FALSE(refusal.ok());
        ASSERT_EQ(reply_error{refusal.moved_by(3)}.number(), refusal.number()) << "it is nowhere";
    }
}

TEST(reply_error, is_an_error_or_a_number)
{
    constexpr reply_error broken{error{errc::bad_checksum, 15}};
    VERIFY(broken.code() == errc::bad_checksum and broken.offset() == 15);
    VERIFY(not(broken == reply_error{parameter_error{15}}));
    VERIFY(reply_error{parameter_error{2}} != reply_error{parameter_error{3}});
}

}  // namespace
