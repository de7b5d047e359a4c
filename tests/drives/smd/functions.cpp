#include <drivecodec/drives/smd/functions.hpp>
#include <drivecodec/modbus/rtu/client.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <vector>

namespace {

using namespace drivecodec;
using smd::read_holding_registers;
using smd::read_input_registers;
using smd::read_range;

TEST(smd_functions, are_those_of_the_manual)
{
    for (unsigned code = 1; code < 0x80; ++code) {
        std::array<std::uint8_t, 2> const pdu{static_cast<std::uint8_t>(code), 0};
        auto const                        is_served = smd::functions::find(pdu, [](auto) {});
        EXPECT_EQ(is_served, code == 3 or code == 4 or code == 6 or code == 16) << code;
    }
}

TEST(smd_functions, read_one_register_or_6_at_24_or_4_at_C99)
{
    for (unsigned first = 0; first <= 0xFFFF; ++first) {
        for (std::uint16_t count = 0; count <= 8; ++count) {
            auto const may =
                count == 1 or (first == 24 and count == 6) or ((first == 89 or first == 95) and count == 4);
            auto const made = read_range::make(static_cast<std::uint16_t>(first), count);
            ASSERT_EQ(made.has_value(), may) << first << ' ' << count;
            if (not made) { ASSERT_EQ(made.error(), (error{errc::bad_quantity, 2})); }
        }
    }
    VERIFY(not read_range::make(24, 0xFFFF));
}

TEST(smd_functions, are_refused_at_run_time_beyond_that)
{
    VERIFY(decode<read_holding_registers::request>("03 00 18 00 06"_hex));
    VERIFY(decode<read_holding_registers::request>("03 00 18 00 07"_hex).error() == error{errc::bad_quantity, 3});
    VERIFY(decode<read_holding_registers::request>("03 00 18 00 02"_hex).error() == error{errc::bad_quantity, 3});
    VERIFY(decode<read_holding_registers::request>("03 00 3C 00 02"_hex).error() == error{errc::bad_quantity, 3});
    VERIFY(decode<read_holding_registers::request>("03 00 3C 00 00"_hex).error() == error{errc::bad_quantity, 3});
    VERIFY(decode<read_holding_registers::request>("03 00 3C 00"_hex).error() == error{errc::truncated, 5});
    VERIFY(decode<read_holding_registers::request>("03 00 3C 00 01 00"_hex).error() == error{errc::trailing_bytes, 5});
    VERIFY(decode<read_holding_registers::request>("04 00 3C 00 01"_hex).error()
           == error{errc::unexpected_function, 0});
    static constexpr auto one = "10 00 28 00 01 02 01 9C"_hex;
    static constexpr auto two = "10 00 28 00 02 04 01 9C 01 9C"_hex;
    VERIFY(decode<smd::write_multiple_registers::request>(one));
    VERIFY(decode<smd::write_multiple_registers::request>(two).error() == error{errc::bad_quantity, 3});
}

TEST(smd_manual, reads_the_drive_status_with_six_registers_at_18h)
{
    constexpr auto asked = read_holding_registers::request{.range = {24, 6}};
    VERIFY(encode(asked) == "03 00 18 00 06"_hex);
    constexpr auto frame = modbus::rtu::encode(1, asked);
    VERIFY(frame.size() == 8);
    static constexpr auto reply =
        modbus::rtu::encode(1, read_holding_registers::basic_response<modbus::register_array<6>>{
                                   .values = modbus::register_array<6>{{0x0201, 0, 0, 0, 0, 0}}});
    constexpr auto answer = modbus::rtu::check(1, asked, reply);
    static_assert(answer.has_value());
    VERIFY(answer->values[0] == 513);
}

TEST(smd_manual, treats_04_as_03)
{
    VERIFY(encode(read_input_registers::request{.range = {24, 6}}) == "04 00 18 00 06"_hex);
    VERIFY(encode(read_input_registers::request{.range = {89, 4}}) == "04 00 59 00 04"_hex);
}

TEST(smd_manual, writes_a_single_register_with_16_too)
{
    VERIFY(encode(smd::write_multiple_registers::of(1, {0x0008})) == "10 00 01 00 01 02 00 08"_hex);
}

TEST(smd_functions, know_a_response_of_another_length)
{
    constexpr auto        asked = read_holding_registers::request{.range = {60, 1}};
    static constexpr auto one   = "03 02 01 F4"_hex;
    static constexpr auto two   = "03 04 01 F4 00 00"_hex;
    static constexpr auto seven = "03 0E 00 00 00 00 00 00 00 00 00 00 00 00 00 00"_hex;
    VERIFY(asked.matches(*decode<read_holding_registers::response>(one)).ok());
    VERIFY(not asked.matches(*decode<read_holding_registers::response>(two)).ok());
    VERIFY(decode<read_holding_registers::response>(seven).error() == error{errc::bad_quantity, 1});
}

}  // namespace
