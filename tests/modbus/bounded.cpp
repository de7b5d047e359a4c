#include <drivecodec/modbus/bounded.hpp>

#include <drivecodec/modbus/coil_view.hpp>
#include <drivecodec/modbus/register_view.hpp>

#include "support/verify.hpp"

#include <vector>

namespace {

using namespace drivecodec;
using modbus::address_block;
using modbus::bounded;
using modbus::coil_array;
using modbus::coil_view;
using modbus::register_array;
using modbus::register_view;

constexpr std::array<std::uint16_t, 126> zeros{};

constexpr std::array<std::uint16_t, 2>   words{0x1234, 0x5678};

constexpr register_view registers_of(std::size_t count) { return register_view{zeros}.subview(0, count); }

TEST(bounded, has_min_to_max_values)
{
    using three_to_five = bounded<register_view, 3, 5>;
    VERIFY(three_to_five::make(registers_of(2)).error() == error{errc::bad_quantity, 0});
    VERIFY(three_to_five::make(registers_of(3))->size() == 3);
    VERIFY(three_to_five::make(registers_of(5))->size() == 5);
    VERIFY(three_to_five::make(registers_of(6)).error() == error{errc::bad_quantity, 0});
    VERIFY(three_to_five::min_count == 3 and three_to_five::max_count == 5);
}

TEST(bounded, may_be_empty_where_that_is_allowed)
{
    using up_to_two = bounded<register_view, 0, 2>;
    VERIFY(up_to_two::make({})->empty());
    VERIFY(not bounded<register_view, 1, 2>::make({}));
}

TEST(bounded, knows_which_counts_fit)
{
    using one_to_125 = bounded<register_view, 1, 125>;
    VERIFY(not one_to_125::fits(0) and one_to_125::fits(1) and one_to_125::fits(125) and not one_to_125::fits(126));
    VERIFY(not one_to_125::fits(0x1'0001));
}

TEST(bounded, is_its_values)
{
    constexpr auto made = *bounded<register_view, 1, 125>::make(words);
    VERIFY(made[1] == 0x5678);
    VERIFY(made.values() == register_view{words});
    VERIFY(made == bounded<register_view, 1, 125>::from_checked(words));
    VERIFY(made != *bounded<register_view, 1, 125>::make(registers_of(2)));
}

TEST(bounded, takes_an_array_that_the_compiler_checks)
{
    constexpr bounded<register_array<2>, 1, 2> made{register_array<2>{{0x1234, 0x5678}}};
    VERIFY(made[0] == 0x1234 and made.size() == 2);
    VERIFY(fixed_size<bounded<register_array<2>, 1, 2>>);
}

TEST(bounded, refuses_more_words_than_a_view_counts)
{
    std::vector<std::uint16_t> const many(0x1'0001);
    EXPECT_FALSE((bounded<register_view, 1, 125>::make(register_view{many})));
}

//=== address_block ===//

using block = address_block<register_view, 123>;

TEST(address_block, has_one_to_max_values)
{
    VERIFY(block::make(0, registers_of(0)).error() == error{errc::bad_quantity, 2});
    VERIFY(block::make(0, registers_of(1))->count() == 1);
    VERIFY(block::make(0, registers_of(123))->count() == 123);
    VERIFY(block::make(0, registers_of(124)).error() == error{errc::bad_quantity, 2});
}

TEST(address_block, ends_at_or_before_65535)
{
    VERIFY(block::make(0xFFFF, registers_of(1))->first() == 0xFFFF);
    VERIFY(block::make(0xFFFF, registers_of(2)).error() == error{errc::bad_address, 0});
    VERIFY(block::make(0xFF85, registers_of(123)).has_value());
    VERIFY(block::make(0xFF86, registers_of(123)).error() == error{errc::bad_address, 0});
}

TEST(address_block, has_a_range_and_values)
{
    constexpr auto made = *block::make(7, words);
    VERIFY(made.range() == *modbus::register_range<123>::make(7, 2));
    VERIFY(made.values() == register_view{words});
    VERIFY(made == block::from_checked(7, words));
    VERIFY(made != *block::make(8, words));
    VERIFY(made != *block::make(7, registers_of(2)));
}

TEST(address_block, takes_an_array_that_the_compiler_checks)
{
    constexpr address_block<register_array<2>, 123> made{0xFFFE, {{0x1234, 0x5678}}};
    VERIFY(made.first() == 0xFFFE and made.count() == 2 and made.values()[1] == 0x5678);
    constexpr address_block<coil_array<3>, 1968> coils{0, {{true, false, true}}};
    VERIFY(coils.count() == 3 and coils.values()[2]);
}

TEST(address_block, refuses_more_words_than_a_view_counts)
{
    std::vector<std::uint16_t> const many(0x1'0001);
    EXPECT_EQ(block::make(0, register_view{many}).error(), (error{errc::bad_quantity, 2}));
}

}  // namespace
