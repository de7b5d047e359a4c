#include <drivecodec/drives/xd1000/link.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;
using xd1000::link_settings;
namespace rtu = modbus::rtu;

TEST(xd1000_link, leaves_the_factory_off_at_19200_8E1_with_a_time_out_of_10_seconds)
{
    constexpr link_settings factory;
    VERIFY(factory.is_off());
    VERIFY(*xd1000::bits_per_second(factory.baud) == 19200);
    VERIFY(*xd1000::to_rtu(factory.format) == rtu::format_8e1);
    VERIFY(factory.time_out == 10.0_s);
    VERIFY(*factory.timing() == rtu::timing::of(19200));
}

TEST(xd1000_manual, gives_baud_rates_and_formats_as_display_texts_only)
{
    // The codes are the ATV12's.
    VERIFY(*xd1000::bits_per_second(xd1000::baud_rate{24}) == 4800);
    VERIFY(*xd1000::bits_per_second(xd1000::baud_rate{28}) == 9600);
    VERIFY(*xd1000::bits_per_second(xd1000::baud_rate{32}) == 19200);
    VERIFY(*xd1000::bits_per_second(xd1000::baud_rate{36}) == 38400);
    VERIFY(*xd1000::to_rtu(xd1000::character_format{2}) == rtu::format_8o1);
    VERIFY(*xd1000::to_rtu(xd1000::character_format{3}) == rtu::format_8e1);
    VERIFY(*xd1000::to_rtu(xd1000::character_format{4}) == rtu::format_8n1);
    VERIFY(*xd1000::to_rtu(xd1000::character_format{5}) == rtu::format_8n2);
}

TEST(xd1000_link, refuses_every_other_code)
{
    int rates   = 0;
    int formats = 0;
    for (unsigned code = 0; code <= 0xFFFF; ++code) {
        rates += xd1000::bits_per_second(static_cast<xd1000::baud_rate>(code)) ? 1 : 0;
        formats += xd1000::to_rtu(static_cast<xd1000::character_format>(code)) ? 1 : 0;
    }
    EXPECT_EQ(rates, 4);
    EXPECT_EQ(formats, 4);
    EXPECT_EQ(link_settings{.baud = xd1000::baud_rate{0}}.timing().error().code(), errc::bad_value);
    EXPECT_EQ(link_settings{.format = xd1000::character_format{0}}.timing().error().code(), errc::bad_value);
}

TEST(xd1000_manual, ends_frames_after_3_characters_and_not_after_3_and_a_half)
{
    constexpr auto line = *link_settings{.baud = xd1000::baud_rate::baud_9600}.timing();
    VERIFY(xd1000::end_of_frame(line) == 3438);  // 3 x 11 bits at 9600, rounded up
    VERIFY(line.inter_frame() == 4011);          // 3.5 x 11 bits
    VERIFY(xd1000::end_of_frame(line) < line.inter_frame());
}

TEST(xd1000_manual, has_address_0_as_off_and_as_delivered)
{
    VERIFY(link_settings{}.address == 0 and link_settings{}.is_off());
    VERIFY(not link_settings{.address = 247}.is_off());
}

}  // namespace
