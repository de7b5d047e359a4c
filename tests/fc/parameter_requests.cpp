#include <drivecodec/fc/parameter_requests.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <limits>

namespace {

using namespace drivecodec::literals;
using drivecodec::encode;
using namespace drivecodec::fc;

constexpr auto start = data_valid(0x047F, 50_percent);

constexpr std::uint16_t raw_of(word_value constant)
{
    return constant.raw;
}

//=== the examples of the manual ===//

TEST(parameter_requests, are_the_examples)
{
    VERIFY(encode(read_value(206, data_not_valid)) == "10 CE 00 00 00 00 00 00 00 00 00 00"_hex);
    VERIFY(encode(read_value(615, 1, data_not_valid)) == "12 67 00 01 00 00 00 00 00 00 00 00"_hex);
    VERIFY(encode(write_word(202, 1000, storage::ram_and_eeprom, start)) == "E0 CA 00 00 00 00 03 E8 04 7F 20 00"_hex);
    VERIFY(encode(write_word(415, 20, storage::ram_and_eeprom, data_not_valid))
           == "E1 9F 00 00 00 00 00 14 00 00 00 00"_hex);
}

//=== each builder ===//

TEST(parameter_requests, write_words_to_ram_or_to_eeprom_as_well)
{
    VERIFY(encode(write_word(202, 1000, storage::ram, start)) == "20 CA 00 00 00 00 03 E8 04 7F 20 00"_hex);
    VERIFY(encode(write_word(615, 255, 1, storage::ram, start)) == "22 67 00 FF 00 00 00 01 04 7F 20 00"_hex);
    VERIFY(encode(write_word(615, 2, 1, storage::ram_and_eeprom, start)) == "E2 67 00 02 00 00 00 01 04 7F 20 00"_hex);
}

TEST(parameter_requests, write_double_words_to_ram_or_to_eeprom_as_well)
{
    VERIFY(encode(write_double_word(291, 0x12345, storage::ram, start)) == "31 23 00 00 00 01 23 45 04 7F 20 00"_hex);
    VERIFY(encode(write_double_word(291, 0x12345, storage::ram_and_eeprom, start))
           == "D1 23 00 00 00 01 23 45 04 7F 20 00"_hex);
    VERIFY(encode(write_double_word(291, 1, 0x12345, storage::ram, start))
           == "31 23 00 01 00 01 23 45 04 7F 20 00"_hex);
    VERIFY(encode(write_double_word(291, 7, -1, storage::ram_and_eeprom, start))
           == "D1 23 00 07 FF FF FF FF 04 7F 20 00"_hex);
}

TEST(parameter_requests, may_have_no_command)
{
    VERIFY(encode(no_command(start)) == "00 00 00 00 00 00 00 00 04 7F 20 00"_hex);
    VERIFY(encode(no_command(data_not_valid)) == "00 00 00 00 00 00 00 00 00 00 00 00"_hex);
}

TEST(parameter_requests, may_have_any_command)
{
    VERIFY(encode(any_command(ak_command::read_description, 1599, ind::from_raw(0x0064), 0, data_not_valid))
           == "46 3F 00 64 00 00 00 00 00 00 00 00"_hex);
    VERIFY(encode(any_command(ak_command{0x9}, 1, ind::from_raw(0x1234), 0x89ABCDEF, data_not_valid))
           == "90 01 12 34 89 AB CD EF 00 00 00 00"_hex);
}

//=== what they take ===//

TEST(parameter_requests, take_constants_from_minus_32768_to_65535_as_a_word)
{
    VERIFY(raw_of(-32768) == 0x8000);
    VERIFY(raw_of(-1) == 0xFFFF);
    VERIFY(raw_of(0) == 0);
    VERIFY(raw_of(65535) == 0xFFFF);
    VERIFY(raw_of(65535U) == 0xFFFF and raw_of(65535ULL) == 0xFFFF);
    VERIFY(raw_of(-32768LL) == 0x8000);
}

TEST(parameter_requests, take_integers_of_up_to_16_bits_as_a_word_at_run_time)
{
    for (int number = -32768; number <= 32767; ++number) {
        word_value const from_signed   = static_cast<std::int16_t>(number);
        word_value const from_unsigned = static_cast<std::uint16_t>(number);
        ASSERT_EQ(from_signed.raw, static_cast<std::uint16_t>(number));
        ASSERT_EQ(from_unsigned.raw, static_cast<std::uint16_t>(number));
    }
    for (int number = 0; number < 256; ++number) {
        word_value const from_byte   = static_cast<std::uint8_t>(number);
        word_value const from_signed = static_cast<std::int8_t>(number);
        ASSERT_EQ(from_byte.raw, number);
        ASSERT_EQ(from_signed.raw, number < 128 ? number : number + 0xFF00);
    }
}

TEST(parameter_requests, take_integers_of_up_to_32_bits_as_a_double_word)
{
    VERIFY(double_word_value{-1}.raw == 0xFFFF'FFFF);
    VERIFY(double_word_value{0xFFFF'FFFFU}.raw == 0xFFFF'FFFF);
    VERIFY(double_word_value{std::int16_t{-2}}.raw == 0xFFFF'FFFE);
    VERIFY(double_word_value{std::uint8_t{200}}.raw == 200);
    VERIFY(double_word_value{std::numeric_limits<std::int32_t>::min()}.raw == 0x8000'0000);
    VERIFY(not std::is_constructible_v<double_word_value, std::int64_t>);
}

constexpr std::uint8_t index_of(array_index_value constant)
{
    return constant.raw;
}

TEST(parameter_requests, take_every_byte_as_an_array_index)
{
    VERIFY(index_of(0) == 0 and index_of(1) == 1 and index_of(255) == 255);
    VERIFY(index_of(255U) == 255 and index_of(255LL) == 255 and index_of(std::int16_t{7}) == 7);
    for (unsigned index = 0; index <= 255; ++index) {
        auto const asked = read_value(615, static_cast<std::uint8_t>(index), data_not_valid);
        ASSERT_EQ(asked.array_index(), index);
        ASSERT_EQ(asked.ind.raw, index);
    }
}

TEST(parameter_requests, take_a_number_known_only_at_run_time)
{
    for (std::uint16_t number = 0; number <= 2047; ++number) {
        auto const asked = read_value(*parameter_number::make(number), data_not_valid);
        ASSERT_EQ(asked.number(), number);
        ASSERT_EQ(asked.command(), ak_command::read_value);
        ASSERT_FALSE(asked.pke.test(pke::bit_11));
    }
}

TEST(parameter_requests, have_what_they_were_given)
{
    static constexpr auto asked = write_word(202, std::int16_t{-5}, storage::ram, start);
    VERIFY(asked.pwe == 0xFFFB and *asked.value<std::int16_t>() == -5);
    VERIFY(asked.process == start);
}

//=== other layouts ===//

TEST(parameter_requests, have_numbers_of_12_bits_and_more_words_in_other_layouts)
{
    using wide = data_layout<4, 12>;
    constexpr std::uint16_t third{0x1122};
    constexpr std::uint16_t fourth{0x3344};
    VERIFY(encode(read_value<fc_layout>(4095, data_not_valid)) == "1F FF 00 00 00 00 00 00 00 00 00 00"_hex);
    VERIFY(encode(write_word<wide>(2048, 1, storage::ram, data_valid<wide>(0x047F, 50_percent, third, fourth)))
           == "28 00 00 00 00 00 00 01 04 7F 20 00 11 22 33 44"_hex);
    VERIFY(encode(write_double_word<wide>(2048, 3, 1, storage::ram, data_not_valid))
           == "38 00 00 03 00 00 00 01 00 00 00 00 00 00 00 00"_hex);
    VERIFY(encode(no_command<data_layout<8>>(data_not_valid)) == std::array<std::uint8_t, 24>{});
}

}  // namespace
