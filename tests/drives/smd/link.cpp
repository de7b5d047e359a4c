#include <drivecodec/drives/smd/link.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;
using smd::link_settings;
using smd::serial_format;
namespace rtu = modbus::rtu;

TEST(smd_link, is_9600_baud_with_four_formats)
{
    VERIFY(smd::baud_rate == 9600);
    VERIFY(*smd::to_rtu(serial_format{0}) == rtu::format_8n2 and *smd::to_rtu(serial_format{1}) == rtu::format_8n1);
    VERIFY(*smd::to_rtu(serial_format{2}) == rtu::format_8e1 and *smd::to_rtu(serial_format{3}) == rtu::format_8o1);
    for (unsigned code = 4; code <= 0xFFFF; ++code) {
        auto const unknown = static_cast<serial_format>(code);
        ASSERT_EQ(smd::to_rtu(unknown).error(), (error{errc::bad_value, 0}));
        ASSERT_EQ(smd::lecom_bits_per_second(unknown).error(), (error{errc::bad_value, 0}));
        ASSERT_FALSE(link_settings{.format = unknown}.timing());
    }
}

TEST(smd_link, leaves_the_factory_as_address_1_with_8N2)
{
    VERIFY(link_settings{}.address.byte() == 1 and link_settings{}.format == serial_format::format_8n2);
    VERIFY(*link_settings{}.timing() == rtu::timing::of(9600, rtu::format_8n2));
}

TEST(smd_link, has_addresses_from_1_to_247_and_no_broadcast)
{
    for (unsigned byte = 0; byte <= 0xFF; ++byte) {
        auto const made = smd::network_address::make(static_cast<std::uint8_t>(byte));
        ASSERT_EQ(made.has_value(), byte >= 1 and byte <= 247) << byte;
        if (made) { ASSERT_EQ(made->byte(), byte); }
        if (not made) { ASSERT_EQ(made.error(), (error{errc::reserved_address, 0})); }
    }
    constexpr smd::network_address drive{5};
    VERIFY(rtu::encode(drive, smd::drive_control.write(smd::command::stop))[0] == 5);
    VERIFY(drive == *smd::network_address::make(5));
}

TEST(smd_manual, calls_c25_a_baud_rate_but_means_the_format_if_C01_is_of_modbus)
{
    VERIFY(*smd::lecom_bits_per_second(serial_format{0}) == 9600);
    VERIFY(*smd::lecom_bits_per_second(serial_format{1}) == 4800);
    VERIFY(*smd::lecom_bits_per_second(serial_format{2}) == 2400);
    VERIFY(*smd::lecom_bits_per_second(serial_format{3}) == 1200);
}

TEST(smd_manual, has_8N1_of_PV507_only_in_one_place_and_of_both_in_another)
{
    for (auto const format : {0, 1, 2, 3}) {
        auto const code = static_cast<serial_format>(format);
        EXPECT_TRUE(smd::is_undisputed(code, smd::pv507));
        EXPECT_EQ(smd::is_undisputed(code, smd::pv400), format != 1);
    }
}

// 8 + 17 characters and two silences of 3.5: 32 characters of 11 bits at 9600.
TEST(smd_link, needs_36_7_milliseconds_for_one_poll_of_the_status)
{
    constexpr auto line = *link_settings{}.timing();
    VERIFY(smd::status_poll_time(line) >= 36'667 and smd::status_poll_time(line) <= 36'670);
    constexpr auto shorter = *link_settings{.format = serial_format::format_8n1}.timing();
    VERIFY(smd::status_poll_time(shorter) >= 33'334 and smd::status_poll_time(shorter) <= 33'337);  // 10 bits
}

TEST(smd_manual, has_a_default_time_out_that_cannot_be_met_as_it_advises)
{
    constexpr auto line = *link_settings{}.timing();
    VERIFY(*smd::advised_interval(smd::factory_fault_time) == 25'000);
    VERIFY(*smd::advised_interval(smd::factory_fault_time) < smd::status_poll_time(line));
    VERIFY(*smd::advised_fault_time(smd::status_poll_time(line)) == 74_ms);
    VERIFY(*smd::advised_interval(74_ms) > smd::status_poll_time(line));
    VERIFY(*smd::advised_interval(73_ms) < smd::status_poll_time(line));
}

TEST(smd_link, advises_less_than_half_of_n23)
{
    for (std::int32_t ms = 0; ms <= 70'000; ++ms) {
        auto const interval = smd::advised_interval({ms, -3});
        ASSERT_EQ(interval.has_value(), ms >= 50 and ms <= 65'535);
        if (interval) { ASSERT_EQ(*interval, static_cast<std::uint32_t>(ms) * 1000 / 2); }
    }
    VERIFY(smd::advised_interval({505, -4}).error() == error{errc::inexact, 0});
    VERIFY(*smd::advised_fault_time(0) == 50_ms and *smd::advised_fault_time(24'999) == 50_ms);
    VERIFY(*smd::advised_fault_time(25'000) == 51_ms);
    VERIFY(*smd::advised_fault_time(32'767'499) == 65'535_ms);
    VERIFY(smd::advised_fault_time(32'767'500).error() == error{errc::out_of_range, 0});
    VERIFY(smd::advised_fault_time(0xFFFF'FFFF).error() == error{errc::out_of_range, 0});
}

}  // namespace
