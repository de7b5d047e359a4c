#include <drivecodec/modbus/file_record.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

#include <random>

namespace {

using namespace drivecodec;
using modbus::basic_file_record;
using modbus::file_record;
using modbus::register_array;
using modbus::register_view;

constexpr auto                           wire = "06 00 04 00 07 00 03 06 AF 04 BE 10 0D"_hex;
constexpr std::array<std::uint16_t, 3>   words{0x06AF, 0x04BE, 0x100D};
constexpr std::array<std::uint16_t, 125> zeros{};

// MODBUS Application Protocol V1.1b3, 6.15.
TEST(file_record, is_the_one_the_specification_prints)
{
    constexpr basic_file_record<register_array<3>> constant{4, 7, {words}};
    VERIFY(encode(constant) == wire);
    VERIFY(*decode<file_record>(wire) == *file_record::make(4, 7, words));
    VERIFY(decode<file_record>(wire)->range() == constant.range());
    VERIFY(decode<file_record>(wire)->values()[2] == 0x100D);
    EXPECT_EQ(properties::wire_of(*file_record::make(4, 7, words)), properties::copy_of(wire));
}

TEST(file_record, has_the_limits_of_its_range)
{
    VERIFY(file_record::make(0, 0, words).error() == error{errc::bad_address, 1});
    VERIFY(file_record::make(1, 10000, words).error() == error{errc::bad_address, 3});
    VERIFY(file_record::make(1, 9998, words).error() == error{errc::bad_address, 3});
    VERIFY(file_record::make(1, 9997, words).has_value());
    VERIFY(file_record::make(1, 0, {}).error() == error{errc::bad_quantity, 5});
    VERIFY(file_record::make(1, 0, zeros).error() == error{errc::bad_quantity, 5});
    VERIFY(file_record::make(1, 0, register_view{zeros}.subview(0, 124)).has_value());
}

TEST(file_record, is_as_long_as_its_length_field_says)
{
    VERIFY(file_record::length("06 00 04 00 07 00"_hex) == message_length::at_least(7));
    VERIFY(file_record::length(bytes{wire}.first(7)) == message_length::exactly(13));
    VERIFY(file_record::check(bytes{wire}.first(6)) == error{errc::truncated, 9});
    VERIFY(file_record::check(bytes{wire}.first(7)) == error{errc::truncated, 13});
    VERIFY(file_record::check(bytes{wire}.first(12)) == error{errc::truncated, 13});
    VERIFY(file_record::check("06 00 04 00 07 00 01 00 00 00"_hex) == error{errc::trailing_bytes, 9});
}

// A length that doubles to more than 16 bits must not become a short record.
TEST(file_record, of_a_length_that_overflows_when_doubled_is_refused)
{
    for (unsigned count = 125; count <= 0xFFFF; ++count) {
        std::array<std::uint8_t, 9> const given{6, 0, 1, 0, 0, static_cast<std::uint8_t>(count >> 8),
                                                static_cast<std::uint8_t>(count)};
        ASSERT_GT(file_record::length(given).size(), 250U) << count;
        ASSERT_EQ(file_record::check(given), (error{errc::bad_quantity, 5})) << count;
    }
}

TEST(file_record, survives_encoding_and_decoding)
{
    std::mt19937 random{7};
    for (int trial = 0; trial < 500; ++trial) {
        std::vector<std::uint16_t> values(1 + random() % 124);
        for (auto& value : values) { value = static_cast<std::uint16_t>(random()); }
        auto const made = file_record::make(static_cast<std::uint16_t>(1 + random() % 0xFFFF),
                                            static_cast<std::uint16_t>(random() % 9876), register_view{values});
        ASSERT_TRUE(made);
        ASSERT_TRUE(properties::round_trips(*made));
    }
}

}  // namespace
