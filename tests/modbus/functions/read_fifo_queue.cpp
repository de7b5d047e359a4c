#include <drivecodec/modbus/functions/read_fifo_queue.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = read_fifo_queue::request;
using response = read_fifo_queue::response;

TEST(read_fifo_queue, is_what_the_specification_prints)
{
    constexpr request asked{.address = 1246};
    VERIFY(encode(asked) == vectors::read_fifo_queue_request);
    VERIFY(*decode<request>(vectors::read_fifo_queue_request) == asked);

    constexpr auto given = *decode<response>(vectors::read_fifo_queue_response);
    VERIFY(given.values.size() == 2 and given.values[0] == 440 and given.values[1] == 4740);
    VERIFY(asked.matches(given).ok());

    constexpr read_fifo_queue::basic_response<register_array<2>> owned{.values = register_array<2>{{440, 4740}}};
    VERIFY(encode(owned) == vectors::read_fifo_queue_response);
}

TEST(read_fifo_queue, has_up_to_31_registers)
{
    std::mt19937               random{13};
    std::vector<std::uint16_t> words(32);
    for (auto& word : words) { word = static_cast<std::uint16_t>(random()); }
    for (std::size_t count = 0; count <= 31; ++count) {
        auto const made = response::make(register_view{std::span{words}.first(count)});
        ASSERT_TRUE(made) << count;
        ASSERT_TRUE(properties::round_trips(*made)) << count;
    }
    EXPECT_EQ(response::make(register_view{words}).error(), (error{errc::bad_quantity, 3}));
}

TEST(read_fifo_queue, has_a_count_up_to_31)
{
    for (unsigned count = 0; count <= 0xFFFF; ++count) {
        auto const                    size = 2 + 2 * count;
        properties::byte_vector const pdu{0x18, static_cast<std::uint8_t>(size >> 8), static_cast<std::uint8_t>(size),
                                          static_cast<std::uint8_t>(count >> 8), static_cast<std::uint8_t>(count)};
        auto const fault = response::check(pdu);
        if (count == 0) {
            ASSERT_EQ(fault, error{});
        } else if (count <= 31) {
            ASSERT_EQ(fault, (error{errc::truncated, 3 + size})) << count;
        } else {
            ASSERT_FALSE(fault.ok()) << count;
            ASSERT_NE(fault.code(), errc::truncated) << count;
        }
    }
    VERIFY(response::check("18 00 40 00 20"_hex) == error{errc::bad_quantity, 3});
    VERIFY(response::check("18 00 42 00 20"_hex) == error{errc::bad_length, 1});
    VERIFY(response::check("18 00 42"_hex) == error{errc::bad_length, 1});  // more than any PDU has
    VERIFY(response::check("18 00 40"_hex) == error{errc::truncated, 67});
}

TEST(read_fifo_queue, has_a_byte_count_that_agrees)
{
    VERIFY(response::check("18 00 00"_hex) == error{errc::bad_length, 1});
    VERIFY(response::check("18 00 01 00"_hex) == error{errc::bad_length, 1});
    VERIFY(response::check("18 00 02 00 01"_hex) == error{errc::bad_length, 1});
    VERIFY(response::check("18 00 03 00 00 00"_hex) == error{errc::bad_length, 1});
    VERIFY(response::check("18 00 05 00 01 00 00 00"_hex) == error{errc::bad_length, 1});
    VERIFY(response::check("18 FF FF 00 01"_hex) == error{errc::bad_length, 1});
    VERIFY(response::check("18 00 04 00 01 00 00"_hex).ok());
}

TEST(read_fifo_queue, survives_encoding_and_decoding_with_every_address)
{
    for (unsigned address = 0; address <= 0xFFFF; ++address) {
        request const asked{.address = static_cast<std::uint16_t>(address)};
        auto const    wire  = encode(asked);
        auto const    again = decode<request>(wire);
        ASSERT_TRUE(again and *again == asked);
    }
}

}  // namespace
