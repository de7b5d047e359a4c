#include <drivecodec/drives/vlt6000/choices.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::vlt6000;

TEST(vlt6000_choices, are_transferred_as_the_numbers_in_brackets)
{
    VERIFY(static_cast<int>(protocol::fc_protocol) == 0 and static_cast<int>(protocol::metasys_n2) == 1);
    VERIFY(static_cast<int>(language::english) == 0 and static_cast<int>(language::danish) == 1);
    VERIFY(static_cast<int>(large_display_read_out::lcp_display_text) == 27);
    VERIFY(static_cast<int>(process_unit::kilowatt) == 0x14);  // of the telegram E19F 0000 0000 0014
}

TEST(vlt6000_choices, have_six_baud_rates)
{
    VERIFY(*bits_per_second(baud_rate{0}) == 300);
    VERIFY(*bits_per_second(baud_rate{1}) == 600);
    VERIFY(*bits_per_second(baud_rate{2}) == 1200);
    VERIFY(*bits_per_second(baud_rate{3}) == 2400);
    VERIFY(*bits_per_second(baud_rate{4}) == 4800);
    VERIFY(*bits_per_second(baud_rate{5}) == 9600);
    VERIFY(*bits_per_second(baud_rate::baud_300) == 300 and *bits_per_second(baud_rate::baud_9600) == 9600);
}

TEST(vlt6000_choices, have_addresses_by_protocol)
{
    VERIFY(*address_limits_of(protocol::fc_protocol) == address_limits{0, 126});
    VERIFY(*address_limits_of(protocol::metasys_n2) == address_limits{1, 255});
    VERIFY(*address_limits_of(protocol::landis_staefa_fln) == address_limits{0, 98});
}

TEST(vlt6000_choices, refuse_every_other_code)
{
    for (unsigned code = 0; code <= 0xFFFF; ++code) {
        auto const rate      = bits_per_second(static_cast<baud_rate>(code));
        auto const addresses = address_limits_of(static_cast<protocol>(code));
        ASSERT_EQ(static_cast<bool>(rate), code <= 5) << code;
        ASSERT_EQ(static_cast<bool>(addresses), code <= 2) << code;
        if (not rate) { ASSERT_EQ(rate.error(), (error{errc::bad_value, 0})); }
        if (not addresses) { ASSERT_EQ(addresses.error(), (error{errc::bad_value, 0})); }
    }
}

TEST(vlt6000_manual, numbers_FLN_2_in_parameter_500_and_3_in_parameter_501)
{
    VERIFY(static_cast<int>(protocol::landis_staefa_fln) == 2);
    VERIFY(*address_limits_of(protocol{2}) == address_limits{0, 98} and not address_limits_of(protocol{3}));
}

}  // namespace
