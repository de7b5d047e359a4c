#include <drivecodec/drives/xd1000/registers.hpp>
#include <drivecodec/modbus/rtu/client.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <vector>

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;
namespace rtu = modbus::rtu;

using drive_settings = registers<switching_frequency, maximum_output_frequency, high_speed, low_speed>;

// The manual's two examples, with its checksums.
constexpr auto asked = drive_settings::read();
constexpr auto reply = "02 03 08 00 28 02 58 01 F4 00 00 52 B0"_hex;

TEST(xd1000_manual, reads_four_words_of_drive_2)
{
    VERIFY(rtu::encode(2, asked) == "02 03 0C 1E 00 04 27 6C"_hex);

    constexpr auto response = rtu::check(2, asked, reply);
    static_assert(response.has_value());
    constexpr modbus::register_view values = response->values;
    VERIFY(drive_settings::value(switching_frequency, values) == 4_kHz);
    VERIFY(drive_settings::value(maximum_output_frequency, values) == 60_Hz);
    VERIFY(drive_settings::value(high_speed, values) == 50_Hz);
    VERIFY(drive_settings::value(low_speed, values) == 0_Hz);
}

TEST(xd1000_manual, writes_000D_to_acc_as_13_seconds_where_its_sister_would_have_one_and_three_tenths)
{
    VERIFY(rtu::encode(2, acc.write(13_s)) == "02 06 23 29 00 0D 92 70"_hex);
    VERIFY(rtu::encode(2, acc.with_exponent<-1>.write(1.3_s)) == "02 06 23 29 00 0D 92 70"_hex);
    VERIFY(acc.make_write(1.3_s).error().code() == errc::inexact);
}

TEST(xd1000_registers, start_the_drive_with_6_7_F)
{
    VERIFY(cmd.write(cia402::command::shutdown).value == 0x0006);
    VERIFY(cmd.write(cia402::command::switch_on).value == 0x0007);
    VERIFY(cmd.write(cia402::command::enable_operation).value == 0x000F);
    VERIFY(cmd.write(cia402::command::enable_operation).address == 8501);
}

TEST(xd1000_registers, take_every_word_that_a_word_can_be_also_at_run_time)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = command_word::from_raw(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(cmd.write(word).value, raw);
        ASSERT_EQ(cmd.make_write(word)->value, raw);
    }
}

TEST(xd1000_registers, are_of_their_types)
{
    VERIFY(eta.value(0x0237).test(status_word::remote));
    VERIFY(rfrd.value(0xFA24) == -1500_rpm);
    VERIFY(lfrd.write(-1500_rpm).value == 0xFA24);
    VERIFY(time_out.write(10.0_s).value == 100 and time_out.write(100_ms).value == 1);
    VERIFY(time_out.make_write(0_s).error().code() == errc::out_of_range);
    VERIFY(time_out.make_write(30.1_s).error().code() == errc::out_of_range);
    VERIFY(modbus_address.write(247).value == 247 and modbus_address.write(0).value == 0);
    VERIFY(baud_rate_setting.write(baud_rate::baud_38400).value == 36);
    VERIFY(baud_rate_setting.make_write(baud_rate{25}).error().code() == errc::out_of_range);
    VERIFY(character_format_setting.write(character_format::format_8n1).value == 4);
    VERIFY(nma3.write(eti.address()).value == 3206);
    VERIFY(eta.make_write({}).error().code() == errc::read_only);
    VERIFY(rfrd.make_write(0_rpm).error().code() == errc::read_only);
    VERIFY(nm1.make_write(0).error().code() == errc::read_only);
    VERIFY(nc1.write(0x000F).value == 0x000F);
}

TEST(xd1000_registers, make_read_refuses_gaps_and_more_than_63)
{
    for (unsigned first = 3000; first < 13000; ++first) {
        for (auto const count : std::array<std::uint16_t, 7>{0, 1, 2, 4, 5, 63, 64}) {
            auto const made  = make_read(static_cast<std::uint16_t>(first), count);
            auto       exist = true;
            for (unsigned i = 0; i < count; ++i) {
                exist = exist and find(static_cast<std::uint16_t>(first + i)) != nullptr;
            }
            ASSERT_EQ(made.has_value(), count >= 1 and count <= 63 and exist) << first << ' ' << count;
            if (not made) {
                ASSERT_EQ(made.error().code(), count < 1 or count > 63 ? errc::bad_quantity : errc::bad_address);
            }
        }
    }
    VERIFY(make_read(3104, 3).error() == error{errc::bad_address, 2});
}

TEST(xd1000_registers, make_write_refuses_gaps_read_only_ones_limits_and_more_than_61)
{
    std::vector<std::uint16_t> const words(62);
    EXPECT_EQ(make_write(3102, words).error().code(), errc::bad_quantity);
    EXPECT_EQ(make_write(3102, std::span{words}.first(61)).error().code(), errc::bad_address);
    constexpr std::array<std::uint16_t, 2> two{1, 2};
    VERIFY(make_write(3104, two).has_value());
    VERIFY(make_write(3105, two).error() == error{errc::bad_address, 1});
    VERIFY(make_write(12741, two).error() == error{errc::read_only, 0});
    VERIFY(make_write(6003, two).error() == error{errc::out_of_range, 0});
}

}  // namespace
