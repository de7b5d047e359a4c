#include <drivecodec/modbus/word_order.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <cmath>
#include <limits>
#include <string_view>

namespace {

using namespace drivecodec::modbus;
using registers_2 = std::array<std::uint16_t, 2>;

constexpr std::array all_orders{word_order::abcd, word_order::cdab, word_order::badc, word_order::dcba};

/// The bytes on the wire that hold 12345678h in each order.
constexpr auto abcd = "12 34 56 78"_hex;
constexpr auto cdab = "56 78 12 34"_hex;
constexpr auto badc = "34 12 78 56"_hex;
constexpr auto dcba = "78 56 34 12"_hex;

template <typename T>
constexpr T read(std::span<std::uint8_t const> wire, word_order order)
{
    return from_registers<T>(register_view::of_wire(wire), 0, order);
}

constexpr auto wire_of(registers_2 words)
{
    std::array<std::uint8_t, 4> wire{};
    register_view{words}.write(wire);
    return wire;
}

TEST(word_order, reads_an_unsigned_number)
{
    VERIFY(read<std::uint32_t>(abcd, word_order::abcd) == 0x12345678);
    VERIFY(read<std::uint32_t>(cdab, word_order::cdab) == 0x12345678);
    VERIFY(read<std::uint32_t>(badc, word_order::badc) == 0x12345678);
    VERIFY(read<std::uint32_t>(dcba, word_order::dcba) == 0x12345678);
    VERIFY(read<std::uint32_t>(dcba, word_order::abcd) == 0x78563412);
}

TEST(word_order, writes_an_unsigned_number)
{
    VERIFY(wire_of(to_registers(0x12345678U, word_order::abcd)) == abcd);
    VERIFY(wire_of(to_registers(0x12345678U, word_order::cdab)) == cdab);
    VERIFY(wire_of(to_registers(0x12345678U, word_order::badc)) == badc);
    VERIFY(wire_of(to_registers(0x12345678U, word_order::dcba)) == dcba);
}

TEST(word_order, reads_and_writes_a_signed_number)
{
    // -2 = FFFFFFFEh
    VERIFY(wire_of(to_registers(std::int32_t{-2}, word_order::abcd)) == "FF FF FF FE"_hex);
    VERIFY(wire_of(to_registers(std::int32_t{-2}, word_order::cdab)) == "FF FE FF FF"_hex);
    VERIFY(wire_of(to_registers(std::int32_t{-2}, word_order::badc)) == "FF FF FE FF"_hex);
    VERIFY(wire_of(to_registers(std::int32_t{-2}, word_order::dcba)) == "FE FF FF FF"_hex);
    VERIFY(read<std::int32_t>("FF FF FF FE"_hex, word_order::abcd) == -2);
    VERIFY(read<std::int32_t>("FF FE FF FF"_hex, word_order::cdab) == -2);
    VERIFY(read<std::int32_t>("FF FF FE FF"_hex, word_order::badc) == -2);
    VERIFY(read<std::int32_t>("FE FF FF FF"_hex, word_order::dcba) == -2);
}

TEST(word_order, reads_and_writes_a_float)
{
    // 123.456 = 42F6E979h
    VERIFY(wire_of(to_registers(123.456F, word_order::abcd)) == "42 F6 E9 79"_hex);
    VERIFY(wire_of(to_registers(123.456F, word_order::cdab)) == "E9 79 42 F6"_hex);
    VERIFY(wire_of(to_registers(123.456F, word_order::badc)) == "F6 42 79 E9"_hex);
    VERIFY(wire_of(to_registers(123.456F, word_order::dcba)) == "79 E9 F6 42"_hex);
    VERIFY(read<float>("42 F6 E9 79"_hex, word_order::abcd) >= 123.456F);
    VERIFY(read<float>("E9 79 42 F6"_hex, word_order::cdab) <= 123.456F);
    VERIFY(read<float>("C1 20 00 00"_hex, word_order::abcd) <= -10.0F);
    VERIFY(read<float>("20 C1 00 00"_hex, word_order::badc) >= -10.0F);
    EXPECT_TRUE(std::isnan(read<float>("7F C0 00 00"_hex, word_order::abcd)));
    EXPECT_TRUE(std::isinf(read<float>("00 00 80 7F"_hex, word_order::dcba)));
}

TEST(word_order, reads_what_it_writes)
{
    for (auto const order : all_orders) {
        for (std::uint32_t bits : {0x00000000U, 0x00000001U, 0x80000000U, 0xFFFFFFFFU, 0x01020304U, 0xDEADBEEFU}) {
            auto const words = to_registers(bits, order);
            EXPECT_EQ(from_registers<std::uint32_t>(words, 0, order), bits);
            auto const number = std::bit_cast<std::int32_t>(bits);
            EXPECT_EQ(from_registers<std::int32_t>(to_registers(number, order), 0, order), number);
        }
        for (auto const number : {0.0F, -0.0F, 1.5F, std::numeric_limits<float>::max(), std::numeric_limits<float>::denorm_min()}) {
            auto const again = from_registers<float>(to_registers(number, order), 0, order);
            EXPECT_EQ(std::bit_cast<std::uint32_t>(again), std::bit_cast<std::uint32_t>(number));
        }
    }
}

TEST(word_order, is_the_same_in_host_words_and_on_the_wire)
{
    constexpr auto wire = "00 01 12 34 56 78 00 02"_hex;
    constexpr std::array<std::uint16_t, 4> words{0x0001, 0x1234, 0x5678, 0x0002};
    for (auto const order : all_orders) {
        for (std::size_t index = 0; index < 3; ++index) {
            EXPECT_EQ(from_registers<std::uint32_t>(words, index, order),
                      from_registers<std::uint32_t>(register_view::of_wire(wire), index, order));
        }
    }
    VERIFY(from_registers<std::uint32_t>(words, 1, word_order::abcd) == 0x12345678);
    VERIFY(from_registers<std::uint32_t>(words, 2, word_order::abcd) == 0x56780002);
}

TEST(word_order, is_of_32_bits)
{
    static_assert(two_registers<std::uint32_t> and two_registers<std::int32_t> and two_registers<float>);
    static_assert(not two_registers<double> and not two_registers<std::uint16_t> and not two_registers<std::uint64_t>);
    static_assert(not two_registers<word_order*>);
}

//=== texts ===//

template <std::size_t N>
std::string_view read_text(std::array<std::uint16_t, N> const& words, std::span<char> to, character_order order)
{
    auto const filled = copy_text(words, to, order);
    return {filled.data(), filled.size()};
}

TEST(text_in_registers, is_read_in_both_orders)
{
    constexpr std::array<std::uint16_t, 2> words{0x4142, 0x4344};
    std::array<char, 4>                    to{};
    EXPECT_EQ(read_text(words, to, character_order::high_byte_first), "ABCD");
    EXPECT_EQ(read_text(words, to, character_order::low_byte_first), "BADC");
    auto const wire = copy_text(register_view::of_wire("41 42 43 44"_hex), to, character_order::high_byte_first);
    EXPECT_EQ(std::string_view(wire.data(), wire.size()), "ABCD");
}

TEST(text_in_registers, is_read_up_to_the_end_of_either)
{
    constexpr std::array<std::uint16_t, 2> words{0x4142, 0x4344};
    std::array<char, 6>                    to{'x', 'x', 'x', 'x', 'x', 'x'};
    EXPECT_EQ(read_text(words, std::span{to}.first(3), character_order::high_byte_first), "ABC");
    EXPECT_EQ(to[3], 'x');
    EXPECT_EQ(read_text(words, std::span{to}.first(1), character_order::low_byte_first), "B");
    EXPECT_EQ(read_text(words, to, character_order::high_byte_first), "ABCD");
    EXPECT_EQ(to[4], 'x');
    EXPECT_EQ(read_text(words, std::span<char>{}, character_order::high_byte_first), "");
    EXPECT_TRUE(copy_text(register_view{}, to, character_order::high_byte_first).empty());
}

TEST(text_in_registers, keeps_padding_and_every_byte)
{
    constexpr std::array<std::uint16_t, 2> words{0x41FF, 0x0020};
    std::array<char, 4>                    to{};
    EXPECT_EQ(read_text(words, to, character_order::high_byte_first), std::string_view("A\xFF\0 ", 4));
}

template <std::size_t N>
constexpr auto write_text(std::string_view text, character_order order, char padding = '\0')
{
    std::array<std::uint16_t, N> to{};
    static_cast<void>(copy_text(text, to, order, padding));
    return to;
}

TEST(text_in_registers, is_written_in_both_orders)
{
    VERIFY(write_text<2>("ABCD", character_order::high_byte_first) == registers_2{0x4142, 0x4344});
    VERIFY(write_text<2>("ABCD", character_order::low_byte_first) == registers_2{0x4241, 0x4443});
}

TEST(text_in_registers, is_padded)
{
    VERIFY(write_text<2>("ABC", character_order::high_byte_first) == registers_2{0x4142, 0x4300});
    VERIFY(write_text<2>("ABC", character_order::low_byte_first, ' ') == registers_2{0x4241, 0x2043});
    VERIFY(write_text<2>("", character_order::high_byte_first, ' ') == registers_2{0x2020, 0x2020});
    VERIFY(write_text<2>("A", character_order::high_byte_first, '\xFF') == registers_2{0x41FF, 0xFFFF});
}

TEST(text_in_registers, says_how_much_of_it_fits)
{
    std::array<std::uint16_t, 2> to{};
    EXPECT_EQ(copy_text(std::string_view{"ABC"}, to, character_order::high_byte_first), 3U);
    EXPECT_EQ(copy_text(std::string_view{"ABCDE"}, to, character_order::high_byte_first), 4U);
    EXPECT_EQ(to, (registers_2{0x4142, 0x4344}));
    EXPECT_EQ(copy_text(std::string_view{"AB"}, std::span<std::uint16_t>{}, character_order::high_byte_first), 0U);
}

TEST(text_in_registers, comes_back_as_it_was)
{
    for (auto const order : {character_order::high_byte_first, character_order::low_byte_first}) {
        auto const          words = write_text<4>("V2.11\x80", order, ' ');
        std::array<char, 8> to{};
        EXPECT_EQ(read_text(words, to, order), "V2.11\x80  ");
    }
}

}  // namespace
