#include <drivecodec/modbus/functions/write_single_register.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = write_single_register::request;
using response = write_single_register::response;

TEST(write_single_register, is_what_the_specification_prints)
{
    constexpr request asked{.address = 1, .value = 3};
    VERIFY(encode(asked) == vectors::write_single_register);
    VERIFY(*decode<request>(vectors::write_single_register) == asked);
    VERIFY(encode(asked.reply()) == vectors::write_single_register);
    VERIFY(decode<response>(vectors::write_single_register)->address == 1);
}

TEST(write_single_register, survives_encoding_and_decoding_with_every_address_and_value)
{
    for (unsigned word = 0; word <= 0xFFFF; ++word) {
        auto const number = static_cast<std::uint16_t>(word);
        for (auto const asked : {request{.address = number, .value = 0xA55A}, request{.address = 0x5AA5, .value = number}}) {
            auto const wire  = encode(asked);
            auto const again = decode<request>(wire);
            ASSERT_TRUE(again and *again == asked) << word;
        }
    }
    EXPECT_TRUE(properties::round_trips(request{.address = 0xFFFF, .value = 0xFFFF}));
    EXPECT_TRUE(properties::round_trips(response{{.address = 0, .value = 0x8000}}));
}

TEST(write_single_register, is_answered_by_its_echo)
{
    constexpr request asked{.address = 1, .value = 3};
    VERIFY(asked.matches(asked.reply()).ok());
    VERIFY(asked.matches(response{{.address = 2, .value = 3}}) == error{errc::unexpected_reply, 1});
    VERIFY(asked.matches(response{{.address = 1, .value = 4}}) == error{errc::unexpected_reply, 3});
    VERIFY(asked.matches(response{{.address = 0x0101, .value = 3}}) == error{errc::unexpected_reply, 1});
    VERIFY(asked.matches(response{{.address = 1, .value = 0x0103}}) == error{errc::unexpected_reply, 3});
    VERIFY(asked.echo_size() == 5);
}

}  // namespace
