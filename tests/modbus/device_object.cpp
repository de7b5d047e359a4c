#include <drivecodec/modbus/device_object.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

namespace {

using namespace drivecodec;
using modbus::device_object;
using modbus::device_object_id;

constexpr auto version = "56 32 2E 31 31"_hex;        // V2.11
constexpr auto wire    = "02 05 56 32 2E 31 31"_hex;  // MODBUS Application Protocol V1.1b3, 6.21

TEST(device_object_id, has_the_number_of_the_specification)
{
    constexpr auto number = [](device_object_id id) { return static_cast<int>(id); };
    VERIFY(number(device_object_id::vendor_name) == 0 and number(device_object_id::product_code) == 1);
    VERIFY(number(device_object_id::major_minor_revision) == 2 and number(device_object_id::vendor_url) == 3);
    VERIFY(number(device_object_id::product_name) == 4 and number(device_object_id::model_name) == 5);
    VERIFY(number(device_object_id::user_application_name) == 6);
}

TEST(device_object, is_the_one_the_specification_prints)
{
    constexpr device_object printed{.id = device_object_id::major_minor_revision, .value = version};
    VERIFY(*decode<device_object>(wire) == printed);
    EXPECT_EQ(properties::wire_of(printed), properties::copy_of(wire));
    EXPECT_EQ(decode<device_object>(wire)->value.data(), wire.data() + 2);
}

TEST(device_object, is_as_long_as_it_says)
{
    VERIFY(device_object::length({}) == message_length::at_least(2));
    VERIFY(device_object::length("02"_hex) == message_length::at_least(2));
    VERIFY(device_object::length("02 05"_hex) == message_length::exactly(7));
    VERIFY(device_object::length("02 FF"_hex) == message_length::exactly(257));
    VERIFY(device_object::check("02"_hex) == error{errc::truncated, 2});
    VERIFY(device_object::check(bytes{wire}.first(6)) == error{errc::truncated, 7});
    VERIFY(device_object::check("02 00 00"_hex) == error{errc::trailing_bytes, 2});
    VERIFY(device_object::check("02 00"_hex).ok());
}

TEST(device_object, compares_id_and_value)
{
    constexpr device_object printed{.id = device_object_id::major_minor_revision, .value = version};
    constexpr device_object other_id{.id = device_object_id::vendor_name, .value = version};
    constexpr device_object other_value{.id = device_object_id::major_minor_revision, .value = {}};
    VERIFY(printed != other_id and printed != other_value);
}

TEST(device_object, survives_encoding_and_decoding_with_every_id_and_size)
{
    std::vector<std::uint8_t> value(255, 0x55);
    for (unsigned number = 0; number <= 0xFF; ++number) {
        device_object const made{.id = static_cast<device_object_id>(number), .value = bytes{value}.first(number)};
        ASSERT_TRUE(properties::round_trips(made)) << number;
    }
}

}  // namespace
