#include <drivecodec/modbus/crc16/table.hpp>

#include "support/verify.hpp"

namespace {

namespace crc16 = drivecodec::modbus::crc16;

TEST(crc16_table, has_an_entry_for_each_value_of_the_low_bits)
{
    VERIFY(crc16::make_table<1>() == std::array<std::uint16_t, 2>{0x0000, 0xA001});
    VERIFY(crc16::make_table<2>() == std::array<std::uint16_t, 4>{0x0000, 0xF001, 0xA001, 0x5000});
}

// MODBUS over Serial Line V1.02, 6.2.2: the first and the last entries of its two tables, put together.
TEST(crc16_table, is_the_one_the_specification_prints)
{
    constexpr auto table = crc16::make_table<8>();
    VERIFY(table[0] == 0x0000);
    VERIFY(table[1] == 0xC0C1);
    VERIFY(table[2] == 0xC181);
    VERIFY(table[3] == 0x0140);
    VERIFY(table[254] == 0x8081);
    VERIFY(table[255] == 0x4040);
}

TEST(crc16_table, zeros_multiply_by_powers_of_x)
{
    constexpr std::uint16_t one = 0x8000;
    VERIFY(crc16::after_zeros(one, 0) == one);
    VERIFY(crc16::after_zeros(one, 1) == one >> 8);
    VERIFY(crc16::after_zeros(one, 2) == 0xA001);  // x^16 = x^15 + x^2 + 1
    VERIFY(crc16::after_zeros(0x1234, 5) == crc16::after_zeros(crc16::after_zeros(0x1234, 2), 3));
}

}  // namespace
