#include <drivecodec/modbus/messages/block_request.hpp>

#include <drivecodec/modbus/coil_view.hpp>
#include <drivecodec/modbus/register_view.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

struct poke {
    static constexpr auto code = static_cast<function_code>(0x41);
};
using registers_4 = block_request<poke, register_view, 4>;
using coils_10    = block_request<poke, coil_view, 10>;

constexpr std::array<std::uint16_t, 5> words{1, 2, 3, 4, 5};

TEST(block_request, is_a_range_a_byte_count_and_values)
{
    constexpr auto made = *registers_4::make(0x1234, register_view{words}.subview(0, 2));
    EXPECT_EQ(properties::wire_of(made), properties::copy_of("41 12 34 00 02 04 00 01 00 02"_hex));
    static constexpr auto wire = "41 12 34 00 02 04 00 01 00 02"_hex;
    VERIFY(*decode<registers_4>(wire) == made);
}

TEST(block_request, has_the_limit_of_its_device)
{
    VERIFY(registers_4::make(0, {}).error() == error{errc::bad_quantity, 3});
    VERIFY(registers_4::make(0, register_view{words}.subview(0, 4)).has_value());
    VERIFY(registers_4::make(0, words).error() == error{errc::bad_quantity, 3});
    VERIFY(registers_4::make(0xFFFF, register_view{words}.subview(0, 2)).error() == error{errc::bad_address, 1});
    VERIFY(registers_4::check("41 00 00 00 00 00"_hex) == error{errc::bad_quantity, 3});
    VERIFY(registers_4::check("41 00 00 00 05 0A"_hex) == error{errc::bad_quantity, 3});
    VERIFY(registers_4::check("41 FF FF 00 02 04 00 00 00 00"_hex) == error{errc::bad_address, 1});
}

TEST(block_request, has_a_byte_count_that_agrees)
{
    VERIFY(registers_4::check("41 00 00 00 01 00"_hex) == error{errc::bad_length, 5});
    VERIFY(registers_4::check("41 00 00 00 01 01 00"_hex) == error{errc::bad_length, 5});
    VERIFY(registers_4::check("41 00 00 00 01 03 00 00 00"_hex) == error{errc::bad_length, 5});
    VERIFY(registers_4::check("41 00 00 00 01 FF 00 00"_hex) == error{errc::bad_length, 5});
    VERIFY(coils_10::check("41 00 00 00 08 02 00 00"_hex) == error{errc::bad_length, 5});
    VERIFY(coils_10::check("41 00 00 00 09 01 00"_hex) == error{errc::bad_length, 5});
    VERIFY(coils_10::check("41 00 00 00 09 02 00 00"_hex).ok());
}

TEST(block_request, is_answered_by_its_range)
{
    constexpr auto made  = *registers_4::make(0x1234, register_view{words}.subview(0, 2));
    constexpr auto reply = made.reply();
    VERIFY(encode(reply) == "41 12 34 00 02"_hex);
    VERIFY(made.matches(reply).ok());
    VERIFY(made.echo_size() == 5);  // the reply is the front of the request

    constexpr registers_4::response other_first{.range = {0x1235, 2}};
    constexpr registers_4::response other_count{.range = {0x1234, 3}};
    VERIFY(made.matches(other_first) == error{errc::unexpected_reply, 1});
    VERIFY(made.matches(other_count) == error{errc::unexpected_reply, 3});
}

TEST(block_request, of_an_array_has_a_known_size)
{
    constexpr block_request<poke, register_array<2>, 4> owned{.block = {7, {{0x1234, 0x5678}}}};
    VERIFY(encode(owned) == "41 00 07 00 02 04 12 34 56 78"_hex);
}

}  // namespace
