#include <drivecodec/modbus/record_list.hpp>

#include <drivecodec/modbus/device_object.hpp>
#include <drivecodec/modbus/file_record_range.hpp>

#include "support/pdu_properties.hpp"
#include "support/hex.hpp"

#include <iterator>

namespace {

using namespace drivecodec;
using modbus::device_object;
using modbus::device_object_id;
using modbus::file_record_range;
using modbus::record_list;

constexpr auto ab = "41 42"_hex;

constexpr std::array<device_object, 3> objects{{{device_object_id{0x00}, ab},  //
                                                {device_object_id{0x80}, {}},
                                                {device_object_id{0xFF}, bytes{ab}.first(1)}}};
constexpr auto                         wire = "00 02 41 42 80 00 FF 01 41"_hex;

TEST(record_list, of_nothing_is_empty)
{
    VERIFY(record_list<device_object>{}.empty() and record_list<device_object>{}.size() == 0);
    VERIFY(record_list<device_object>{}.wire_size() == 0);
    VERIFY(record_list<device_object>{}.begin() == record_list<device_object>{}.end());
    VERIFY(record_list<device_object>{} == record_list<device_object>::of_wire({}));
    VERIFY(record_list<device_object>::check({}).ok());
}

TEST(record_list, reads_wire_bytes_and_host_objects_alike)
{
    constexpr auto of_wire = record_list<device_object>::of_wire(wire);
    constexpr auto of_host = record_list<device_object>{objects};
    VERIFY(record_list<device_object>::check(wire).ok());
    VERIFY(of_wire.size() == 3 and of_host.size() == 3);
    VERIFY(of_wire.wire_size() == 9 and of_host.wire_size() == 9);
    VERIFY(of_wire == of_host and of_host == of_wire);
    VERIFY(not of_wire.empty() and not of_host.empty());
}

TEST(record_list, is_iterated)
{
    VERIFY(std::input_iterator<record_list<device_object>::iterator>);
    for (auto const& list : {record_list<device_object>::of_wire(wire), record_list<device_object>{objects}}) {
        std::size_t at = 0;
        for (auto const object : list) { EXPECT_EQ(object, objects[at++]); }
        EXPECT_EQ(at, 3U);
    }
}

TEST(record_list, steps_before_and_after)
{
    for (auto const& list : {record_list<device_object>::of_wire(wire), record_list<device_object>{objects}}) {
        auto       it     = list.begin();
        auto const before = it++;
        EXPECT_EQ(*before, objects[0]);
        EXPECT_EQ(*it, objects[1]);
        EXPECT_EQ(*++it, objects[2]);
        EXPECT_TRUE(++it == list.end());
    }
}

TEST(record_list, writes_the_same_bytes_from_both)
{
    for (auto const& list : {record_list<device_object>::of_wire(wire), record_list<device_object>{objects}}) {
        EXPECT_EQ(properties::wire_of(list), properties::copy_of(wire));
    }
}

TEST(record_list, compares_records)
{
    static constexpr auto other   = "00 02 41 42 80 00 FF 01 42"_hex;
    static constexpr auto shorter = "00 02 41 42 80 00"_hex;
    constexpr auto        list    = record_list<device_object>{objects};
    VERIFY(list != record_list<device_object>::of_wire(other));
    VERIFY(list != record_list<device_object>::of_wire(shorter));
    VERIFY(record_list<device_object>::of_wire(shorter) != list);
    VERIFY(list != record_list<device_object>{});
}

TEST(record_list, ends_where_its_bytes_end)
{
    using list = record_list<device_object>;
    VERIFY(list::check("00 02 41 42 80"_hex) == error{errc::bad_length, 4});
    VERIFY(list::check("00 02 41 42 80 01"_hex) == error{errc::bad_length, 4});
    VERIFY(list::check("00 03 41 42"_hex) == error{errc::bad_length, 0});
    VERIFY(list::check("00 FF 41 42"_hex) == error{errc::bad_length, 0});
    VERIFY(list::check("00"_hex) == error{errc::bad_length, 0});
}

TEST(record_list, says_in_which_record_what_is_wrong)
{
    using list = record_list<file_record_range>;
    VERIFY(list::check("06 00 04 00 01 00 02 06 00 03 00 09 00 02"_hex).ok());
    VERIFY(list::check("06 00 04 00 01 00 02 07 00 03 00 09 00 02"_hex) == error{errc::bad_value, 7});
    VERIFY(list::check("06 00 04 00 01 00 02 06 00 00 00 09 00 02"_hex) == error{errc::bad_address, 8});
    VERIFY(list::check("06 00 04 00 01 00 02 06 00 03 00 09 00"_hex) == error{errc::bad_length, 7});
}

TEST(record_list, borrows_and_does_not_copy)
{
    auto const list = record_list<device_object>::of_wire(wire);
    EXPECT_EQ((*list.begin()).value.data(), wire.data() + 2);
}

}  // namespace
