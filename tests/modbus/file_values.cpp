#include <drivecodec/modbus/file_values.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

namespace {

using namespace drivecodec;
using modbus::file_values;
using modbus::register_view;

constexpr std::array<std::uint16_t, 2>   words{0x0DFE, 0x0020};
constexpr std::array<std::uint16_t, 125> zeros{};
constexpr auto                           wire = "05 06 0D FE 00 20"_hex;

// MODBUS Application Protocol V1.1b3, 6.14: the first group of its response.
TEST(file_values, are_those_the_specification_prints)
{
    VERIFY(*decode<file_values>(wire) == *file_values::make(words));
    VERIFY(decode<file_values>(wire)->values[1] == 0x0020);
    EXPECT_EQ(properties::wire_of(*file_values::make(words)), properties::copy_of(wire));
}

TEST(file_values, are_1_to_124_registers)
{
    VERIFY(file_values::make({}).error() == error{errc::bad_quantity, 0});
    VERIFY(file_values::make(register_view{zeros}.subview(0, 1)).has_value());
    VERIFY(file_values::make(register_view{zeros}.subview(0, 124)).has_value());
    VERIFY(file_values::make(zeros).error() == error{errc::bad_quantity, 0});
    VERIFY(file_values::check("01 06"_hex) == error{errc::bad_quantity, 0});
    VERIFY(file_values::check("03 06 00 00"_hex).ok());
    VERIFY(file_values::check("FB 06 00 00"_hex) == error{errc::bad_quantity, 0});
    VERIFY(file_values::check("F9 06 00 00"_hex) == error{errc::truncated, 250});
}

TEST(file_values, have_an_odd_length)
{
    for (unsigned length = 0; length <= 0xFF; length += 2) {
        std::vector<std::uint8_t> given(length + 1);
        given[0] = static_cast<std::uint8_t>(length);
        if (length > 0) { given[1] = 6; }
        EXPECT_EQ(file_values::check(given), (error{errc::bad_length, 0})) << length;
    }
}

TEST(file_values, have_reference_type_6)
{
    VERIFY(file_values::check("03 07 00 00"_hex) == error{errc::bad_value, 1});
    VERIFY(file_values::check("03 00 00 00"_hex) == error{errc::bad_value, 1});
}

TEST(file_values, are_as_long_as_they_say)
{
    VERIFY(file_values::length({}) == message_length::at_least(1));
    VERIFY(file_values::length("05"_hex) == message_length::exactly(6));
    VERIFY(file_values::check({}) == error{errc::truncated, 4});
    VERIFY(file_values::check(bytes{wire}.first(1)) == error{errc::truncated, 6});
    VERIFY(file_values::check(bytes{wire}.first(5)) == error{errc::truncated, 6});
    VERIFY(file_values::check("03 06 00 00 00"_hex) == error{errc::trailing_bytes, 4});
}

TEST(file_values, survive_encoding_and_decoding_at_every_size)
{
    for (std::size_t count = 1; count <= 124; ++count) {
        ASSERT_TRUE(properties::round_trips(*file_values::make(register_view{zeros}.subview(0, count))));
    }
}

}  // namespace
