#include <drivecodec/modbus/functions/mask_write_register.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = mask_write_register::request;
using response = mask_write_register::response;

constexpr request asked{.address = 4, .and_mask = 0xF2, .or_mask = 0x25};

TEST(mask_write_register, is_what_the_specification_prints)
{
    VERIFY(encode(asked) == vectors::mask_write_register);
    VERIFY(*decode<request>(vectors::mask_write_register) == asked);
    VERIFY(encode(asked.reply()) == vectors::mask_write_register);
    VERIFY(decode<response>(vectors::mask_write_register)->or_mask == 0x25);
}

// 6.16: current contents 12h, AND mask F2h, OR mask 25h: 17h.
TEST(mask_write_register, does_what_the_specification_calculates)
{
    VERIFY(asked.apply(0x12) == 0x17);
}

TEST(mask_write_register, decides_each_bit_by_itself)
{
    for (unsigned bits = 0; bits < 8; ++bits) {
        auto const word     = [](unsigned bit) { return static_cast<std::uint16_t>(bit != 0 ? 0xFFFF : 0); };
        auto const current  = bits & 1U;
        auto const kept     = bits & 2U;
        auto const wanted   = bits & 4U;
        auto const expected = kept != 0 ? current : wanted;
        EXPECT_EQ((request{.address = 0, .and_mask = word(kept), .or_mask = word(wanted)}.apply(word(current))),
                  word(expected))
            << bits;
    }
}

TEST(mask_write_register, without_an_and_mask_writes_the_or_mask)
{
    VERIFY(request{.address = 0, .and_mask = 0, .or_mask = 0xA55A}.apply(0x1234) == 0xA55A);
    VERIFY(request{.address = 0, .and_mask = 0xFFFF, .or_mask = 0xA55A}.apply(0x1234) == 0x1234);
}

TEST(mask_write_register, survives_encoding_and_decoding)
{
    std::mt19937 random{12};
    auto const   word = [&] { return static_cast<std::uint16_t>(random()); };
    for (int trial = 0; trial < 1000; ++trial) {
        request const made{.address = word(), .and_mask = word(), .or_mask = word()};
        ASSERT_TRUE(properties::round_trips(made));
        ASSERT_TRUE(properties::round_trips(made.reply()));
    }
}

TEST(mask_write_register, is_answered_by_its_echo)
{
    VERIFY(asked.matches(asked.reply()).ok());
    VERIFY(asked.matches(response{{.address = 5, .and_mask = 0xF2, .or_mask = 0x25}}) == error{errc::unexpected_reply, 1});
    VERIFY(asked.matches(response{{.address = 4, .and_mask = 0xF3, .or_mask = 0x25}}) == error{errc::unexpected_reply, 3});
    VERIFY(asked.matches(response{{.address = 4, .and_mask = 0xF2, .or_mask = 0x24}}) == error{errc::unexpected_reply, 5});
    VERIFY(asked.echo_size() == 7);
}

}  // namespace
