#include <drivecodec/modbus/functions/write_single_coil.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = write_single_coil::request;
using response = write_single_coil::response;

TEST(write_single_coil, is_what_the_specification_prints)
{
    constexpr request asked{.address = 172, .value = true};
    VERIFY(encode(asked) == vectors::write_single_coil);
    VERIFY(*decode<request>(vectors::write_single_coil) == asked);
    VERIFY(encode(asked.reply()) == vectors::write_single_coil);
    VERIFY(decode<response>(vectors::write_single_coil)->value);
}

TEST(write_single_coil, has_no_value_but_FF00_and_0000)
{
    for (unsigned value = 0; value <= 0xFFFF; ++value) {
        std::array<std::uint8_t, 5> const pdu{5, 0, 1, static_cast<std::uint8_t>(value >> 8),
                                              static_cast<std::uint8_t>(value)};
        auto const expected = value == 0xFF00 or value == 0x0000 ? error{} : error{errc::bad_value, 3};
        ASSERT_EQ(request::check(pdu), expected) << value;
        ASSERT_EQ(response::check(pdu), expected) << value;
    }
    VERIFY(decode<request>("05 00 01 12 34"_hex).error() == error{errc::bad_value, 3});
}

TEST(write_single_coil, survives_encoding_and_decoding_with_every_address)
{
    for (unsigned address = 0; address <= 0xFFFF; ++address) {
        for (auto const value : {false, true}) {
            request const asked{.address = static_cast<std::uint16_t>(address), .value = value};
            auto const    wire  = encode(asked);
            auto const    again = decode<request>(wire);
            ASSERT_TRUE(again and *again == asked);
        }
    }
    EXPECT_TRUE(properties::round_trips(request{.address = 0xFFFF, .value = true}));
    EXPECT_TRUE(properties::round_trips(response{{.address = 0xFFFF, .value = false}}));
}

TEST(write_single_coil, is_answered_by_its_echo)
{
    constexpr request asked{.address = 172, .value = true};
    VERIFY(asked.matches(asked.reply()).ok());
    VERIFY(asked.matches(response{{.address = 173, .value = true}}) == error{errc::unexpected_reply, 1});
    VERIFY(asked.matches(response{{.address = 172, .value = false}}) == error{errc::unexpected_reply, 3});
    VERIFY(asked.matches(response{{.address = 173, .value = false}}) == error{errc::unexpected_reply, 1});
    VERIFY(asked.echo_size() == 5);
}

}  // namespace
