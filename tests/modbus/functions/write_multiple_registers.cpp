#include <drivecodec/modbus/functions/write_multiple_registers.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = write_multiple_registers::request;
using response = write_multiple_registers::response;

constexpr std::array<std::uint16_t, 2> words{0x000A, 0x0102};

TEST(write_multiple_registers, is_what_the_specification_prints)
{
    constexpr auto constant = write_multiple_registers::of(1, {0x000A, 0x0102});
    constexpr auto asked    = *request::make(1, words);
    VERIFY(encode(constant) == vectors::write_multiple_registers_request);
    VERIFY(*decode<request>(vectors::write_multiple_registers_request) == asked);
    VERIFY(encode(asked.reply()) == vectors::write_multiple_registers_response);
    VERIFY(encode(constant.reply()) == vectors::write_multiple_registers_response);
    VERIFY(*decode<response>(vectors::write_multiple_registers_response) == asked.reply());
    EXPECT_EQ(properties::wire_of(asked), properties::copy_of(vectors::write_multiple_registers_request));
}

//=== limits ===//

TEST(write_multiple_registers, writes_1_to_123)
{
    std::vector<std::uint16_t> const many(124);
    auto const make_of = [&](std::size_t count) { return request::make(0, register_view{many}.subview(0, count)); };
    EXPECT_EQ(make_of(0).error(), (error{errc::bad_quantity, 3}));
    EXPECT_EQ(make_of(1)->wire_size(), 8U);
    EXPECT_EQ(make_of(123)->wire_size(), 252U);
    EXPECT_EQ(make_of(124).error(), (error{errc::bad_quantity, 3}));

    for (unsigned count = 0; count <= 0xFFFF; ++count) {
        std::array<std::uint8_t, 6> const pdu{0x10,
                                              0,
                                              0,
                                              static_cast<std::uint8_t>(count >> 8),
                                              static_cast<std::uint8_t>(count),
                                              static_cast<std::uint8_t>(2 * count)};
        auto const expected = count < 1 or count > 123 ? error{errc::bad_quantity, 3} : error{errc::truncated, 6 + 2 * count};
        ASSERT_EQ(request::check(pdu), expected) << count;
        auto const expected_back = count < 1 or count > 123 ? error{errc::bad_quantity, 3} : error{};
        ASSERT_EQ(response::check(bytes{pdu}.first(5)), expected_back) << count;
    }
}

TEST(write_multiple_registers, writes_none_beyond_65535)
{
    VERIFY(request::make(0xFFFE, words).has_value());
    VERIFY(request::make(0xFFFF, words).error() == error{errc::bad_address, 1});
    VERIFY(request::check("10 FF FF 00 02 04 00 00 00 00"_hex) == error{errc::bad_address, 1});
    VERIFY(response::check("10 FF FF 00 02"_hex) == error{errc::bad_address, 1});
    VERIFY(response::check("10 FF FF 00 01"_hex).ok());
}

TEST(write_multiple_registers, has_a_byte_count_that_agrees)
{
    for (unsigned size = 0; size <= 0xFF; ++size) {
        properties::byte_vector pdu(6 + size);
        pdu[0] = 0x10;
        pdu[4] = 3;
        pdu[5] = static_cast<std::uint8_t>(size);
        EXPECT_EQ(request::check(pdu), (size == 6 ? error{} : error{errc::bad_length, 5})) << size;
    }
}

TEST(write_multiple_registers, has_the_limit_of_its_device)
{
    using small = basic_write_multiple_registers<4>;
    VERIFY(small::request::check("10 00 00 00 04 08 00 00 00 00 00 00 00 00"_hex).ok());
    VERIFY(small::request::check("10 00 00 00 05 0A"_hex) == error{errc::bad_quantity, 3});
    VERIFY(small::response::check("10 00 00 00 05"_hex) == error{errc::bad_quantity, 3});
    VERIFY(basic_write_multiple_registers<1>::request::make(0, words).error() == error{errc::bad_quantity, 3});
}

//=== both ways ===//

TEST(write_multiple_registers, survives_encoding_and_decoding_from_host_words_and_wire_bytes)
{
    std::mt19937 random{14};
    for (std::size_t count = 1; count <= 123; ++count) {
        std::vector<std::uint16_t> host(count);
        for (auto& word : host) { word = static_cast<std::uint16_t>(random()); }
        auto const first = static_cast<std::uint16_t>(random() % (0x10001 - count));
        auto const made  = request::make(first, register_view{host});
        ASSERT_TRUE(made);
        ASSERT_TRUE(properties::round_trips(*made)) << count;
        ASSERT_TRUE(properties::round_trips(made->reply())) << count;

        auto const wire    = properties::wire_of(*made);
        auto const decoded = decode<request>(wire);
        ASSERT_EQ(properties::wire_of(*request::make(first, decoded->block.values())), wire);
        ASSERT_TRUE(decoded->matches(made->reply()).ok());
        // The reply is the front of the request.
        auto const back = encode(made->reply());
        ASSERT_TRUE(same_bytes(back, bytes{wire}.first(made->echo_size())));
    }
}

TEST(write_multiple_registers, is_answered_by_its_range)
{
    constexpr auto     asked = *request::make(1, words);
    constexpr response right{.range = {1, 2}};
    constexpr response other_first{.range = {2, 2}};
    constexpr response other_count{.range = {1, 3}};
    VERIFY(asked.matches(right).ok());
    VERIFY(asked.matches(other_first) == error{errc::unexpected_reply, 1});
    VERIFY(asked.matches(other_count) == error{errc::unexpected_reply, 3});
}

}  // namespace
