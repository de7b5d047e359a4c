#include <drivecodec/drives/xd1000/functions.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <vector>

namespace {

using namespace drivecodec;
using xd1000::read_holding_registers;

TEST(xd1000_functions, are_those_of_the_manual)
{
    for (unsigned code = 1; code < 0x80; ++code) {
        std::array<std::uint8_t, 2> const pdu{static_cast<std::uint8_t>(code), 0x0E};
        auto const                        is_served = xd1000::functions::find(pdu, [](auto) {});
        EXPECT_EQ(is_served, code == 3 or code == 6 or code == 16 or code == 23 or code == 43) << code;
    }
}

TEST(xd1000_manual, gives_as_max_pdu_length_what_are_quantities_of_registers)
{
    VERIFY(decode<read_holding_registers::request>("03 0C 1E 00 3F"_hex));
    VERIFY(decode<read_holding_registers::request>("03 0C 1E 00 40"_hex).error() == error{errc::bad_quantity, 3});

    std::vector<std::uint16_t> const words(63);
    EXPECT_TRUE(xd1000::write_multiple_registers::request::make(0, std::span{words}.first(61)));
    EXPECT_EQ(xd1000::write_multiple_registers::request::make(0, std::span{words}.first(62)).error().code(),
              errc::bad_quantity);
    // Both limits of registers are PDUs of 128 bytes.
    EXPECT_EQ(xd1000::read_holding_registers::response::make(words)->wire_size(), 128U);
    EXPECT_EQ(xd1000::write_multiple_registers::request::make(0, std::span{words}.first(61))->wire_size(), 128U);
}

TEST(xd1000_manual, limits_function_23_to_4_and_4_and_shows_it_with_3)
{
    using function = xd1000::read_write_multiple_registers;
    for (std::uint16_t count = 0; count <= 6; ++count) {
        std::vector<std::uint16_t> const words(count);
        auto const                       range = function::range_to_read::make(12741, count);
        EXPECT_EQ(range.has_value(), count >= 1 and count <= 4);
        EXPECT_EQ(function::request::make({12741, 4}, 12761, words).has_value(), count >= 1 and count <= 4);
    }
}

}  // namespace
