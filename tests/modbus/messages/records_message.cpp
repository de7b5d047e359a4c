#include <drivecodec/modbus/messages/records_message.hpp>

#include <drivecodec/modbus/device_object.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

struct label {
    static constexpr auto code = static_cast<function_code>(0x41);
};
/// 3 to 10 bytes of records.
using labels = records_message<label, record_list<device_object>, 3, 10>;

constexpr auto                         letters = "41 42 43 44 45 46 47 48 49"_hex;
constexpr std::array<device_object, 2> two{
    {{device_object_id{1}, bytes{letters}.first(2)}, {device_object_id{2}, bytes{letters}.first(1)}}};

TEST(records_message, is_a_byte_count_and_records)
{
    static constexpr auto wire = "41 07 01 02 41 42 02 01 41"_hex;
    constexpr auto        made = *labels::make(record_list<device_object>{two});
    EXPECT_EQ(properties::wire_of(made), properties::copy_of(wire));
    VERIFY(*decode<labels>(wire) == made);
    VERIFY(decode<labels>(wire)->records().size() == 2);
}

TEST(records_message, has_a_least_and_a_greatest_size)
{
    static constexpr auto of = [](std::size_t size) {
        std::array<device_object, 1> const one{{{device_object_id{1}, bytes{letters}.first(size)}}};
        auto const                         made = labels::make(record_list<device_object>{one});
        return made ? error{} : made.error();
    };
    VERIFY(of(0) == error{errc::bad_quantity, 1});
    VERIFY(of(1).ok());
    VERIFY(of(8).ok());
    VERIFY(of(9) == error{errc::bad_quantity, 1});
    VERIFY(labels::make({}).error() == error{errc::bad_quantity, 1});
    VERIFY(labels::check("41 02 01 00"_hex) == error{errc::bad_quantity, 1});
    VERIFY(labels::check("41 0B 01 09 41 42 43 44 45 46 47 48 49"_hex) == error{errc::bad_quantity, 1});
}

TEST(records_message, is_as_long_as_its_byte_count_says)
{
    VERIFY(labels::length("41"_hex) == message_length::at_least(2));
    VERIFY(labels::length("41 07"_hex) == message_length::exactly(9));
    VERIFY(labels::check("41"_hex) == error{errc::truncated, 5});
    VERIFY(labels::check("41 07 01 02"_hex) == error{errc::truncated, 9});
    VERIFY(labels::check("41 03 01 01 41 00"_hex) == error{errc::trailing_bytes, 5});
}

TEST(records_message, counts_offsets_from_its_own_begin)
{
    VERIFY(labels::check("41 07 01 02 41 42 02 02 41"_hex) == error{errc::bad_length, 6});
    VERIFY(labels::check("41 03 01 02 41"_hex) == error{errc::bad_length, 2});
}

}  // namespace
