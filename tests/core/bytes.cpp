#include <drivecodec/core/bytes.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <span>
#include <string>
#include <vector>

namespace {

using namespace drivecodec;

//=== wire fields ===//

TEST(wire_field, knows_where_it_begins_and_ends)
{
    VERIFY(u8_at<0>::begin == 0 and u8_at<0>::end == 1);
    VERIFY(u8_at<7>::begin == 7 and u8_at<7>::end == 8);
    VERIFY(be16_at<0>::begin == 0 and be16_at<0>::end == 2);
    VERIFY(be16_at<3>::begin == 3 and be16_at<3>::end == 5);
}

TEST(wire_field, is_loaded_from_its_place)
{
    VERIFY(u8_at<0>::load("12 34 56"_hex) == 0x12);
    VERIFY(u8_at<2>::load("12 34 56"_hex) == 0x56);
    VERIFY(be16_at<0>::load("12 34 56"_hex) == 0x1234);
    VERIFY(be16_at<1>::load("12 34 56"_hex) == 0x3456);
    VERIFY(be16_at<0>::load("FF FE"_hex) == 0xFFFE);
}

TEST(wire_field, is_stored_at_its_place_and_nowhere_else)
{
    constexpr auto stored = [] {
        std::array<std::uint8_t, 5> wire{0xEE, 0xEE, 0xEE, 0xEE, 0xEE};
        be16_at<1>::store(wire, 0x1234);
        u8_at<4>::store(wire, 0x56);
        return wire;
    };
    VERIFY(stored() == "EE 12 34 EE 56"_hex);
}

TEST(wire_field, survives_storing_and_loading_with_every_value)
{
    std::array<std::uint8_t, 4> wire{};
    for (unsigned value = 0; value <= 0xFFFF; ++value) {
        auto const word = static_cast<std::uint16_t>(value);
        be16_at<1>::store(wire, word);
        ASSERT_EQ(be16_at<1>::load(wire), word);
        ASSERT_EQ(wire[1] * 256 + wire[2], word);
        ASSERT_EQ(wire[0] + wire[3], 0);
    }
}

//=== helpers ===//

TEST(copy_bytes, copies_to_the_front_and_leaves_the_rest)
{
    constexpr auto copied = [] {
        std::array<std::uint8_t, 4> to{0xEE, 0xEE, 0xEE, 0xEE};
        copy_bytes("01 02 03"_hex, to);
        copy_bytes({}, to);
        return to;
    };
    VERIFY(copied() == "01 02 03 EE"_hex);
}

TEST(same_bytes, compares_sizes_and_contents)
{
    VERIFY(same_bytes({}, {}));
    VERIFY(same_bytes("01 02"_hex, "01 02"_hex));
    VERIFY(not same_bytes("01 02"_hex, "01 03"_hex));
    VERIFY(not same_bytes("01 02"_hex, "00 02"_hex));
    VERIFY(not same_bytes("01 02"_hex, "01 02 03"_hex));
    VERIFY(not same_bytes("01"_hex, {}));
}

TEST(saturate_16, keeps_too_many_too_many)
{
    VERIFY(saturate_16(0) == 0);
    VERIFY(saturate_16(0xFFFE) == 0xFFFE);
    VERIFY(saturate_16(0xFFFF) == 0xFFFF);
    VERIFY(saturate_16(0x1'0000) == 0xFFFF);
    VERIFY(saturate_16(0x1'0001) == 0xFFFF);
}

TEST(first_at_most, is_all_of_what_is_not_longer)
{
    constexpr auto size_of = [](std::size_t size, std::size_t most) {
        std::array<std::uint8_t, 8> buffer{};
        auto const                  front = first_at_most(mutable_bytes{buffer}.first(size), most);
        return front.data() == buffer.data() ? front.size() : 99;
    };
    VERIFY(size_of(0, 0) == 0 and size_of(0, 5) == 0);
    VERIFY(size_of(4, 5) == 4);
    VERIFY(size_of(5, 5) == 5);
    VERIFY(size_of(6, 5) == 5);
    VERIFY(size_of(8, 0) == 0);
    VERIFY(first_at_most({}, 256).empty());
}

TEST(owning_temporary, is_a_container_about_to_die)
{
    using array = std::array<std::uint8_t, 3>;
    VERIFY(owning_temporary<array>);
    VERIFY(owning_temporary<array const>);
    VERIFY(owning_temporary<std::vector<std::uint8_t>>);
    VERIFY(not owning_temporary<array&>);
    VERIFY(not owning_temporary<array const&>);
    VERIFY(not owning_temporary<bytes>);
    VERIFY(not owning_temporary<mutable_bytes const>);
}

TEST(borrowable_by, is_what_a_span_of_elements_can_be_made_of)
{
    struct view {};
    VERIFY(borrowable_by<std::array<std::uint16_t, 3>, std::uint16_t, view>);
    VERIFY(borrowable_by<std::vector<std::uint16_t>, std::uint16_t, view>);
    VERIFY(borrowable_by<std::span<std::uint16_t>, std::uint16_t, view>);
    VERIFY(borrowable_by<std::span<std::uint16_t const>, std::uint16_t, view>);
    VERIFY(not borrowable_by<std::vector<std::uint8_t>, std::uint16_t, view>);
    VERIFY(not borrowable_by<int, std::uint16_t, view>);
    VERIFY(not borrowable_by<view, std::uint16_t, view>);
}

}  // namespace
