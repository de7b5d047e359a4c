#include <drivecodec/modbus/address_range.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using modbus::coil_range;
using modbus::register_range;

constexpr error bad_quantity{errc::bad_quantity, 2};
constexpr error bad_address{errc::bad_address, 0};

TEST(address_range, keeps_what_it_is_given)
{
    constexpr register_range<125> made{0x006B, 3};
    VERIFY(made.first() == 0x006B and made.count() == 3);
    VERIFY(made == *register_range<125>::make(0x006B, 3));
    VERIFY(made == register_range<125>::from_checked(0x006B, 3));
    VERIFY(made != *register_range<125>::make(0x006B, 4));
    VERIFY(made != *register_range<125>::make(0x006C, 3));
    VERIFY(register_range<125>::max_count == 125);
}

TEST(address_range, has_one_to_max_registers)
{
    VERIFY(register_range<125>::make(0, 0).error() == bad_quantity);
    VERIFY(register_range<125>::make(0, 1).has_value());
    VERIFY(register_range<125>::make(0, 125).has_value());
    VERIFY(register_range<125>::make(0, 126).error() == bad_quantity);
    VERIFY(register_range<125>::make(0, 0xFFFF).error() == bad_quantity);
}

TEST(address_range, has_one_to_max_coils)
{
    VERIFY(coil_range<2000>::make(0, 0).error() == bad_quantity);
    VERIFY(coil_range<2000>::make(0, 2000).has_value());
    VERIFY(coil_range<2000>::make(0, 2001).error() == bad_quantity);
}

TEST(address_range, has_the_limit_of_its_device)
{
    VERIFY(register_range<63>::make(0, 63).has_value() and not register_range<63>::make(0, 64));
    VERIFY(register_range<61>::make(0, 61).has_value() and not register_range<61>::make(0, 62));
    VERIFY(register_range<4>::make(0, 4).has_value() and not register_range<4>::make(0, 5));
    VERIFY(register_range<1>::make(0, 1).has_value() and not register_range<1>::make(0, 2));
}

TEST(address_range, ends_at_or_before_65535)
{
    VERIFY(register_range<125>::make(0xFFFF, 1).has_value());
    VERIFY(register_range<125>::make(0xFFFF, 2).error() == bad_address);
    VERIFY(register_range<125>::make(0xFF83, 125).has_value());
    VERIFY(register_range<125>::make(0xFF84, 125).error() == bad_address);
    VERIFY(coil_range<2000>::make(0xF830, 2000).has_value());
    VERIFY(coil_range<2000>::make(0xF831, 2000).error() == bad_address);

    constexpr register_range<125> last{0xFFFF, 1};
    constexpr register_range<125> longest{0xFF83, 125};
    VERIFY(last.first() == 0xFFFF and longest.count() == 125);
}

TEST(address_range, says_first_what_is_wrong_with_the_count)
{
    VERIFY(register_range<125>::make(0xFFFF, 126).error() == bad_quantity);
    VERIFY(register_range<125>::make(0xFFFF, 0).error() == bad_quantity);
}

TEST(address_range, is_made_of_every_first_address_with_what_fits)
{
    for (unsigned first = 0; first <= 0xFFFF; ++first) {
        auto const left = 0x1'0000 - first;
        for (unsigned const count : {1U, 2U, 124U, 125U}) {
            auto const made = register_range<125>::make(static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(count));
            ASSERT_EQ(made.has_value(), count <= left) << first << " " << count;
        }
    }
}

TEST(addressed, knows_its_size_on_the_wire)
{
    VERIFY(modbus::registers::wire_size(0) == 0 and modbus::registers::wire_size(125) == 250);
    VERIFY(modbus::registers::max_count(250) == 125 and modbus::registers::max_count(251) == 125);
    VERIFY(modbus::coils::wire_size(0) == 0 and modbus::coils::wire_size(1) == 1);
    VERIFY(modbus::coils::wire_size(8) == 1 and modbus::coils::wire_size(9) == 2);
    VERIFY(modbus::coils::wire_size(1968) == 246 and modbus::coils::wire_size(2000) == 250);
    VERIFY(modbus::coils::max_count(250) == 2000);
}

}  // namespace
