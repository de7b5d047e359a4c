#include <drivecodec/modbus/functions/read_write_multiple_registers.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = read_write_multiple_registers::request;
using response = read_write_multiple_registers::response;

constexpr std::array<std::uint16_t, 3> words{0xFF, 0xFF, 0xFF};

TEST(read_write_multiple_registers, is_what_the_specification_prints)
{
    constexpr auto constant = read_write_multiple_registers::of({3, 6}, 14, {0xFF, 0xFF, 0xFF});
    VERIFY(encode(constant) == vectors::read_write_multiple_registers_request);

    constexpr auto asked = *decode<request>(vectors::read_write_multiple_registers_request);
    VERIFY(asked.read_range.first() == 3 and asked.read_range.count() == 6);
    VERIFY(asked.write_block.first() == 14 and asked.write_block.values() == register_view{words});
    VERIFY(asked == *request::make({3, 6}, 14, words));
    EXPECT_EQ(properties::wire_of(asked), properties::copy_of(vectors::read_write_multiple_registers_request));

    constexpr auto given = *decode<response>(vectors::read_write_multiple_registers_response);
    VERIFY(given.values.size() == 6 and given.values[1] == 0x0ACD and given.values[5] == 0xFF);
    VERIFY(asked.matches(given).ok());
    VERIFY(constant.matches(given).ok());
}

//=== limits ===//

properties::byte_vector pdu_of(unsigned read_first, unsigned read_count, unsigned write_first, unsigned write_count)
{
    properties::byte_vector pdu{0x17};
    for (auto const word : {read_first, read_count, write_first, write_count}) {
        pdu.push_back(static_cast<std::uint8_t>(word >> 8));
        pdu.push_back(static_cast<std::uint8_t>(word));
    }
    pdu.push_back(static_cast<std::uint8_t>(2 * write_count));
    return pdu;
}

TEST(read_write_multiple_registers, reads_1_to_125)
{
    for (unsigned count = 0; count <= 0xFFFF; ++count) {
        auto const allowed = count >= 1 and count <= 125;
        ASSERT_EQ(request::check(pdu_of(0, count, 0, 1)),
                  (allowed ? error{errc::truncated, 12} : error{errc::bad_quantity, 3}))
            << count;
    }
}

TEST(read_write_multiple_registers, writes_1_to_121)
{
    for (unsigned count = 0; count <= 0xFFFF; ++count) {
        auto const allowed = count >= 1 and count <= 121;
        ASSERT_EQ(request::check(pdu_of(0, 1, 0, count)),
                  (allowed ? error{errc::truncated, 10 + 2 * count} : error{errc::bad_quantity, 7}))
            << count;
    }
    std::vector<std::uint16_t> const many(122);
    auto const                       asked = register_range<125>::from_checked(0, 1);
    EXPECT_EQ(request::make(asked, 0, {}).error(), (error{errc::bad_quantity, 7}));
    EXPECT_EQ(request::make(asked, 0, register_view{many}.subview(0, 121))->wire_size(), 252U);
    EXPECT_EQ(request::make(asked, 0, register_view{many}).error(), (error{errc::bad_quantity, 7}));
}

TEST(read_write_multiple_registers, goes_not_beyond_65535)
{
    VERIFY(request::check("17 FF FF 00 02 00 00 00 01 02 00 00"_hex) == error{errc::bad_address, 1});
    VERIFY(request::check("17 FF FF 00 01 FF FF 00 02 04 00 00 00 00"_hex) == error{errc::bad_address, 5});
    VERIFY(request::check("17 FF FF 00 02 FF FF 00 02 04 00 00 00 00"_hex) == error{errc::bad_address, 1});
    VERIFY(request::check("17 FF FF 00 01 FF FF 00 01 02 00 00"_hex).ok());
    VERIFY(request::make({0, 1}, 0xFFFE, words).error() == error{errc::bad_address, 5});
    VERIFY(request::make({0, 1}, 0xFFFD, words).has_value());
}

TEST(read_write_multiple_registers, has_a_byte_count_that_agrees)
{
    for (unsigned size = 0; size <= 0xFF; ++size) {
        auto pdu = pdu_of(0, 1, 0, 3);
        pdu[9]   = static_cast<std::uint8_t>(size);
        pdu.resize(10 + size);
        EXPECT_EQ(request::check(pdu), (size == 6 ? error{} : error{errc::bad_length, 9})) << size;
    }
}

TEST(read_write_multiple_registers, that_ends_behind_its_byte_count_is_truncated)
{
    VERIFY(request::check(bytes{vectors::read_write_multiple_registers_request}.first(10)) == error{errc::truncated, 16});
    VERIFY(request::check(bytes{vectors::read_write_multiple_registers_request}.first(9)) == error{errc::truncated, 12});
}

TEST(read_write_multiple_registers, has_the_limits_of_its_device)
{
    using small = basic_read_write_multiple_registers<4, 1>;
    EXPECT_TRUE(small::request::check("17 00 00 00 04 00 00 00 01 02 00 00"_hex).ok());
    EXPECT_EQ(small::request::check(pdu_of(0, 5, 0, 1)), (error{errc::bad_quantity, 3}));
    EXPECT_EQ(small::request::check(pdu_of(0, 4, 0, 2)), (error{errc::bad_quantity, 7}));
    VERIFY(small::response::check("17 0A 00 00 00 00 00 00 00 00 00 00"_hex) == error{errc::bad_quantity, 1});
}

//=== both ways ===//

TEST(read_write_multiple_registers, survives_encoding_and_decoding)
{
    std::mt19937 random{16};
    for (std::size_t count = 1; count <= 121; ++count) {
        std::vector<std::uint16_t> host(count);
        for (auto& word : host) { word = static_cast<std::uint16_t>(random()); }
        auto const range = register_range<125>::make(static_cast<std::uint16_t>(random() % 0xFF00),
                                                     static_cast<std::uint16_t>(1 + random() % 125));
        auto const made  = request::make(*range, static_cast<std::uint16_t>(random() % 0xFF00), register_view{host});
        ASSERT_TRUE(made);
        ASSERT_TRUE(properties::round_trips(*made)) << count;
        ASSERT_TRUE(properties::round_trips(*response::make(register_view{host}))) << count;
    }
}

TEST(read_write_multiple_registers, is_answered_by_as_many_registers_as_it_reads)
{
    std::vector<std::uint16_t> const many(125);
    for (std::uint16_t asked = 1; asked <= 125; ++asked) {
        auto const reading = request::make(register_range<125>::from_checked(0, asked), 0, words);
        for (std::size_t given = 1; given <= 125; ++given) {
            auto const reply = *response::make(register_view{many}.subview(0, given));
            ASSERT_EQ(reading->matches(reply), (asked == given ? error{} : error{errc::unexpected_reply, 1}));
        }
    }
}

TEST(read_write_multiple_registers, compares_both_ranges)
{
    constexpr auto asked = *request::make({3, 6}, 14, words);
    VERIFY(asked != *request::make({3, 5}, 14, words));
    VERIFY(asked != *request::make({3, 6}, 15, words));
}

}  // namespace
