#include <drivecodec/modbus/file_record_range.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

#include <random>

namespace {

using namespace drivecodec;
using modbus::file_record_range;

constexpr error bad_file{errc::bad_address, 1};
constexpr error bad_record{errc::bad_address, 3};
constexpr error bad_length{errc::bad_quantity, 5};

// MODBUS Application Protocol V1.1b3, 6.14: the second group of its example.
TEST(file_record_range, is_the_one_the_specification_prints)
{
    constexpr file_record_range printed{3, 9, 2};
    VERIFY(encode(printed) == "06 00 03 00 09 00 02"_hex);
    VERIFY(*decode<file_record_range>("06 00 03 00 09 00 02"_hex) == printed);
    VERIFY(printed.file() == 3 and printed.record() == 9 and printed.count() == 2);
}

TEST(file_record_range, has_a_file_from_1_to_65535)
{
    VERIFY(file_record_range::make(0, 0, 1).error() == bad_file);
    VERIFY(file_record_range::make(1, 0, 1).has_value());
    VERIFY(file_record_range::make(0xFFFF, 0, 1).has_value());
    VERIFY(file_record_range::check("06 00 00 00 00 00 01"_hex) == bad_file);
}

TEST(file_record_range, has_records_from_0_to_9999)
{
    VERIFY(file_record_range::make(1, 9999, 1).has_value());
    VERIFY(file_record_range::make(1, 10000, 1).error() == bad_record);
    VERIFY(file_record_range::make(1, 0xFFFF, 1).error() == bad_record);
    VERIFY(file_record_range::make(1, 9999, 2).error() == bad_record);
    VERIFY(file_record_range::make(1, 9876, 124).has_value());
    VERIFY(file_record_range::make(1, 9877, 124).error() == bad_record);
    VERIFY(file_record_range::check("06 00 01 27 10 00 01"_hex) == bad_record);
    VERIFY(file_record_range::check("06 00 01 27 0F 00 02"_hex) == bad_record);
    VERIFY(file_record_range::check("06 00 01 27 0F 00 01"_hex).ok());
}

TEST(file_record_range, has_1_to_124_registers)
{
    VERIFY(file_record_range::make(1, 0, 0).error() == bad_length);
    VERIFY(file_record_range::make(1, 0, 124).has_value());
    VERIFY(file_record_range::make(1, 0, 125).error() == bad_length);
    VERIFY(file_record_range::make(1, 0, 0x8001).error() == bad_length);
    VERIFY(file_record_range::check("06 00 01 00 00 80 01"_hex) == bad_length);
}

TEST(file_record_range, has_reference_type_6)
{
    for (unsigned type = 0; type <= 0xFF; ++type) {
        std::array<std::uint8_t, 7> const wire{static_cast<std::uint8_t>(type), 0, 1, 0, 0, 0, 1};
        EXPECT_EQ(file_record_range::check(wire), (type == 6 ? error{} : error{errc::bad_value, 0})) << type;
    }
}

TEST(file_record_range, has_seven_bytes)
{
    constexpr auto wire = "06 00 03 00 09 00 02 00"_hex;
    for (std::size_t size = 0; size < 7; ++size) {
        EXPECT_EQ(file_record_range::check(bytes{wire}.first(size)), (error{errc::truncated, 7}));
        EXPECT_EQ(file_record_range::length(bytes{wire}.first(size)), message_length::exactly(7));
    }
    EXPECT_EQ(file_record_range::check(wire), (error{errc::trailing_bytes, 7}));
}

TEST(file_record_range, survives_encoding_and_decoding)
{
    std::mt19937 random{6};
    for (int trial = 0; trial < 1000; ++trial) {
        auto const length = 1 + random() % 124;
        auto const record = random() % (10001 - length);
        auto const made   = file_record_range::make(static_cast<std::uint16_t>(1 + random() % 0xFFFF),
                                                    static_cast<std::uint16_t>(record), static_cast<std::uint16_t>(length));
        ASSERT_TRUE(made);
        ASSERT_TRUE(properties::round_trips(*made));
    }
}

}  // namespace
