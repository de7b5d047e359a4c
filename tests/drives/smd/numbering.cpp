#include <drivecodec/drives/smd/numbering.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using smd::register_number;

constexpr error no_such_register{errc::bad_address, 0};

TEST(smd_manual, writes_its_quick_start_in_references_of_which_each_is_one_more_than_what_is_sent)
{
    VERIFY(register_number::from_reference(40049).smd() == 48);  // 7.2: "password to Modbus register 40049"
    VERIFY(register_number::from_reference(40002).smd() == 1);   // 7.2: "Modbus register 40002", "AC Tech register 1"
    VERIFY(register_number::from_reference(40041).smd() == 40);  // 7.3: "40041 (AC Tech register 40)"
    VERIFY(register_number::from_reference(40025).smd() == 24);  // 7.4: "AC Tech register 24", "40025"
    VERIFY(register_number::from_reference(40027).smd() == 26);  // 7.4: the third word of the block
    // The next after the first would unlock parameters only.
    VERIFY(register_number::from_reference(40050).smd() == 49);
}

TEST(smd_manual, numbers_modbus_registers_one_greater_than_its_own)
{
    VERIFY(register_number::from_smd(24).modbus() == 25);  // "Register #24 (Modbus Register #25)"
    VERIFY(register_number::from_modbus(25).smd() == 24);
    VERIFY(register_number::from_smd(1).modbus() == 2);  // "Register #1 (Modbus Register #2)"
    // 3.3: "#0 through #50 (Modbus Registers #1 to #51)", "#51 through #255 (Modbus Registers #52 to #256)".
    VERIFY(register_number::from_modbus(1).smd() == 0 and register_number::from_modbus(51).smd() == 50);
    VERIFY(register_number::from_modbus(52).smd() == 51 and register_number::from_modbus(256).smd() == 255);
}

TEST(smd_manual, counts_its_registers_from_0_once_and_from_1_once_and_describes_no_0)
{
    VERIFY(register_number::from_smd(0).modbus() == 1 and register_number::from_smd(0).holding_reference() == 40001);
}

TEST(smd_register_number, is_the_same_from_each_numbering)
{
    for (int number = 0; number <= 255; ++number) {
        auto const one = register_number::make_from_smd(number);
        ASSERT_TRUE(one);
        EXPECT_EQ(one->smd(), number);
        EXPECT_EQ(one->modbus(), number + 1);
        EXPECT_EQ(one->holding_reference(), 40001 + number);
        EXPECT_EQ(one->input_reference(), 30001 + number);
        EXPECT_EQ(register_number::make_from_modbus(one->modbus()), one);
        EXPECT_EQ(register_number::make_from_reference(one->holding_reference()), one);
        EXPECT_EQ(register_number::make_from_reference(one->input_reference()), one);
    }
    VERIFY(register_number::from_reference(30025) == register_number::from_reference(40025));
    VERIFY(not(register_number::from_smd(24) == register_number::from_smd(25)));
}

TEST(smd_register_number, of_any_other_number_is_refused)
{
    for (long long number = -70'000; number <= 140'000; ++number) {
        ASSERT_EQ(register_number::make_from_smd(number).has_value(), number >= 0 and number <= 255) << number;
        ASSERT_EQ(register_number::make_from_modbus(number).has_value(), number >= 1 and number <= 256) << number;
        ASSERT_EQ(register_number::make_from_reference(number).has_value(),
                  (number >= 30'001 and number <= 30'256) or (number >= 40'001 and number <= 40'256))
            << number;
    }
    VERIFY(register_number::make_from_smd(256) == no_such_register);
    VERIFY(register_number::make_from_modbus(0) == no_such_register);
    VERIFY(register_number::make_from_reference(40000) == no_such_register);
    VERIFY(register_number::make_from_reference(30000) == no_such_register);
    VERIFY(register_number::make_from_reference(400'025) == no_such_register);
    for (auto const number : {-0x7FFF'FFFF'FFFF'FFFF - 1, -0x7FFF'FFFF'FFFF'FFFF, 0x7FFF'FFFF'FFFF'FFFF}) {
        EXPECT_FALSE(register_number::make_from_smd(number));
        EXPECT_FALSE(register_number::make_from_modbus(number));
        EXPECT_FALSE(register_number::make_from_reference(number));
    }
}

}  // namespace
