#include <drivecodec/modbus/functions/read_file_record.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = read_file_record::request;
using response = read_file_record::response;

constexpr file_record_range                first_group{4, 1, 2};
constexpr file_record_range                second_group{3, 9, 2};
constexpr std::array<file_record_range, 2> groups{first_group, second_group};
constexpr std::array<std::uint16_t, 2>     first_words{0x0DFE, 0x0020};
constexpr std::array<std::uint16_t, 2>     second_words{0x33CD, 0x0040};
constexpr std::array<std::uint16_t, 125>   zeros{};

constexpr file_values values_of(register_view words) { return *file_values::make(words); }

TEST(read_file_record, is_what_the_specification_prints)
{
    constexpr auto asked = *request::make(groups);
    VERIFY(*decode<request>(vectors::read_file_record_request) == asked);
    VERIFY(decode<request>(vectors::read_file_record_request)->records().size() == 2);
    EXPECT_EQ(properties::wire_of(asked), properties::copy_of(vectors::read_file_record_request));

    static constexpr std::array<file_values, 2> values{values_of(first_words), values_of(second_words)};
    constexpr auto                              given = *response::make(values);
    VERIFY(*decode<response>(vectors::read_file_record_response) == given);
    VERIFY(asked.matches(given).ok());
    EXPECT_EQ(properties::wire_of(given), properties::copy_of(vectors::read_file_record_response));
}

//=== requests ===//

TEST(read_file_record, has_a_byte_count_from_7_to_245)
{
    for (unsigned size = 0; size <= 0xFF; ++size) {
        properties::byte_vector pdu{0x14, static_cast<std::uint8_t>(size)};
        while (pdu.size() < 2 + size) {
            for (auto const byte : "06 00 01 00 00 00 01"_hex) { pdu.push_back(byte); }
        }
        pdu.resize(2 + size);

        auto const fault = request::check(pdu);
        if (size < 7 or size > 245) {
            EXPECT_EQ(fault, (error{errc::bad_quantity, 1})) << size;
        } else if (size % 7 != 0) {
            EXPECT_EQ(fault, (error{errc::bad_length, 2 + size - size % 7})) << size;
        } else {
            EXPECT_EQ(fault, error{}) << size;
        }
    }
}

TEST(read_file_record, asks_for_1_to_35_ranges)
{
    std::vector<file_record_range> const ranges(36, *file_record_range::make(1, 0, 1));
    auto const make_of = [&](std::size_t count) { return request::make(std::span{ranges}.first(count)); };
    EXPECT_EQ(make_of(0).error(), (error{errc::bad_quantity, 1}));
    for (std::size_t count = 1; count <= 35; ++count) { EXPECT_TRUE(properties::round_trips(*make_of(count))) << count; }
    EXPECT_EQ(make_of(36).error(), (error{errc::bad_quantity, 1}));
}

TEST(read_file_record, checks_every_range)
{
    VERIFY(request::check("14 07 05 00 04 00 01 00 02"_hex) == error{errc::bad_value, 2});
    VERIFY(request::check("14 07 06 00 00 00 01 00 02"_hex) == error{errc::bad_address, 3});
    VERIFY(request::check("14 07 06 00 04 27 10 00 02"_hex) == error{errc::bad_address, 5});
    VERIFY(request::check("14 07 06 00 04 27 0F 00 02"_hex) == error{errc::bad_address, 5});
    VERIFY(request::check("14 07 06 00 04 00 01 00 00"_hex) == error{errc::bad_quantity, 7});
    VERIFY(request::check("14 07 06 00 04 00 01 80 01"_hex) == error{errc::bad_quantity, 7});
    VERIFY(request::check("14 0E 06 00 04 00 01 00 02 06 00 00 00 09 00 02"_hex) == error{errc::bad_address, 10});
}

// Several sub-requests that together exceed a PDU: 2 bytes and the registers of each, 250 in all.
TEST(read_file_record, asks_for_no_more_than_a_response_can_carry)
{
    VERIFY(request::check("14 07 06 00 01 00 00 00 7C"_hex).ok());                                             // 250
    VERIFY(request::check("14 07 06 00 01 00 00 00 7D"_hex) == error{errc::bad_quantity, 7});                  // 252
    VERIFY(request::check("14 0E 06 00 01 00 00 00 3D 06 00 01 00 00 00 3E"_hex).ok());                        // 124 + 126
    VERIFY(request::check("14 0E 06 00 01 00 00 00 3E 06 00 01 00 00 00 3E"_hex) == error{errc::bad_quantity, 14});  // 252
    VERIFY(request::check("14 0E 06 00 01 00 00 00 7C 06 00 01 00 00 00 01"_hex) == error{errc::bad_quantity, 14});
    VERIFY(request::check("14 15 06 00 01 00 00 00 7C 06 00 01 00 00 00 7C 06 00 01 00 00 00 7C"_hex)
           == error{errc::bad_quantity, 14});

    static constexpr std::array<file_record_range, 2> fits{{{1, 0, 61}, {1, 0, 62}}};
    static constexpr std::array<file_record_range, 2> exceeds{{{1, 0, 62}, {1, 0, 62}}};
    VERIFY(request::make(fits).has_value());
    VERIFY(request::make(exceeds).error() == error{errc::bad_quantity, 1});
}

TEST(read_file_record, survives_encoding_and_decoding)
{
    std::mt19937 random{18};
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<file_record_range> ranges;
        for (std::size_t count = 1 + random() % 10; count > 0; --count) {
            ranges.push_back(*file_record_range::make(static_cast<std::uint16_t>(1 + random() % 0xFFFF),
                                                      static_cast<std::uint16_t>(random() % 9989),
                                                      static_cast<std::uint16_t>(1 + random() % 11)));
        }
        auto const made = request::make(std::span<file_record_range const>{ranges});
        ASSERT_TRUE(made);
        ASSERT_TRUE(properties::round_trips(*made));
    }
}

//=== responses ===//

TEST(read_file_record, is_answered_with_an_even_byte_count)
{
    for (unsigned size = 0; size <= 0xFF; ++size) {
        properties::byte_vector pdu{0x14, static_cast<std::uint8_t>(size)};
        if (size > 0) { pdu.push_back(static_cast<std::uint8_t>(size - 1)); }
        if (size > 1) { pdu.push_back(6); }
        pdu.resize(2 + size);

        auto expected = error{};
        if (size % 2 != 0) {
            expected = {errc::bad_length, 1};
        } else if (size < 4 or size > 251) {
            expected = {errc::bad_quantity, 1};
        }
        EXPECT_EQ(response::check(pdu), expected) << size;
    }
}

TEST(read_file_record, is_answered_with_odd_lengths_of_at_least_3)
{
    VERIFY(response::check("14 04 03 06 00 00"_hex).ok());
    VERIFY(response::check("14 04 02 06 00 00"_hex) == error{errc::bad_length, 2});
    VERIFY(response::check("14 04 01 06 01 06"_hex) == error{errc::bad_quantity, 2});
    VERIFY(response::check("14 04 00 06 00 00"_hex) == error{errc::bad_length, 2});
    VERIFY(response::check("14 04 05 06 00 00"_hex) == error{errc::bad_length, 2});
    VERIFY(response::check("14 04 FF 06 00 00"_hex) == error{errc::bad_length, 2});
    VERIFY(response::check("14 08 03 06 00 00 03 07 00 00"_hex) == error{errc::bad_value, 7});
    VERIFY(response::check("14 06 03 06 00 00 01 06"_hex) == error{errc::bad_quantity, 6});
}

TEST(read_file_record, is_answered_with_no_more_than_fits)
{
    static constexpr std::array<file_values, 2> fits{values_of(register_view{zeros}.subview(0, 61)),
                                                     values_of(register_view{zeros}.subview(0, 62))};
    static constexpr std::array<file_values, 2> exceeds{values_of(register_view{zeros}.subview(0, 62)),
                                                        values_of(register_view{zeros}.subview(0, 62))};
    EXPECT_TRUE(properties::round_trips(*response::make(fits)));
    VERIFY(response::make(fits)->wire_size() == 252);
    VERIFY(response::make(exceeds).error() == error{errc::bad_quantity, 1});
    VERIFY(response::make({}).error() == error{errc::bad_quantity, 1});
}

TEST(read_file_record, is_answered_with_as_many_values_for_each_range)
{
    constexpr auto asked = *request::make(groups);
    static constexpr std::array<file_values, 3> values{values_of(first_words), values_of(second_words), values_of(first_words)};
    static constexpr std::array<file_values, 2> first_short{values_of(register_view{zeros}.subview(0, 1)),
                                                            values_of(register_view{zeros}.subview(0, 3))};
    static constexpr std::array<file_values, 2> second_long{values_of(first_words),
                                                            values_of(register_view{zeros}.subview(0, 3))};
    constexpr auto matches = [asked](std::span<file_values const> given) { return asked.matches(*response::make(given)); };
    VERIFY(matches(std::span{values}.first(2)).ok());
    VERIFY(matches(std::span{values}.first(1)) == error{errc::unexpected_reply, 1});
    VERIFY(matches(values) == error{errc::unexpected_reply, 1});
    VERIFY(matches(first_short) == error{errc::unexpected_reply, 2});
    VERIFY(matches(second_long) == error{errc::unexpected_reply, 8});
}

}  // namespace
