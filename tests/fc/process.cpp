#include <drivecodec/fc/process.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <random>
#include <vector>

namespace {

using namespace drivecodec::literals;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using namespace drivecodec::fc;
using four_words = data_layout<4>;
using most_words = data_layout<16, 12>;

template <typename Block>
constexpr auto wire_of(Block const& block)
{
    return drivecodec::encode(block);
}

//=== the examples of the manual ===//

// VLT 6000 manual, "Example - Control word and serial communication reference", "Example - Status word".
TEST(process, encodes_the_examples)
{
    VERIFY(wire_of(data_valid(0x047F, 50_percent)) == "04 7F 20 00"_hex);
    VERIFY(wire_of(data_valid(0x047F, -50_percent)) == "04 7F E0 00"_hex);
    VERIFY(wire_of(process_status{0x0F03, 50_percent}) == "0F 03 20 00"_hex);
}

TEST(process, decodes_the_examples)
{
    static constexpr auto command = drivecodec::decode<process_command>("04 7F E0 00"_hex);
    VERIFY(command->control_word() == 0x047F and command->is_data_valid());
    VERIFY(command->reference() == reference{-50_percent});
    VERIFY(command->pcd(0) == 0x047F and command->pcd(1) == 0xE000 and command->pcd().size() == 2);

    static constexpr auto status = drivecodec::decode<process_status>("0F 03 20 00"_hex);
    VERIFY(status->status_word() == 0x0F03);
    VERIFY(*status->output_frequency().frequency(0_Hz, 50_Hz) == 25_Hz);
}

//=== data valid ===//

TEST(process, is_obeyed_or_expressly_not)
{
    VERIFY(wire_of(process_command{data_not_valid}) == "00 00 00 00"_hex);
    VERIFY(not process_command{data_not_valid}.is_data_valid());
    VERIFY(not std::is_default_constructible_v<process_command>);
    VERIFY(not std::is_constructible_v<process_command, std::uint16_t, reference>);
}

TEST(process, has_bit_10_in_every_word_that_is_data_valid)
{
    for (unsigned word = 0; word <= 0xFFFF; ++word) {
        auto const made = data_valid(static_cast<std::uint16_t>(word), reference::from_raw(0x1234));
        ASSERT_TRUE(made.is_data_valid());
        ASSERT_EQ(made.control_word(), word | 0x0400U);
        ASSERT_EQ(made.reference().raw(), 0x1234);
    }
}

TEST(process, survives_with_every_word_also_without_bit_10)
{
    for (unsigned word = 0; word <= 0xFFFF; ++word) {
        auto const                        high = static_cast<std::uint8_t>(word >> 8);
        auto const                        low  = static_cast<std::uint8_t>(word);
        std::array<std::uint8_t, 4> const wire{high, low, low, high};

        auto const command = drivecodec::decode<process_command>(wire);
        ASSERT_EQ(command->control_word(), word);
        ASSERT_EQ(command->is_data_valid(), (high & 0x04) != 0);
        ASSERT_EQ(wire_of(*command), wire);

        auto const status = drivecodec::decode<process_status>(wire);
        ASSERT_EQ(status->status_word(), word);
        ASSERT_EQ(status->output_frequency().raw(), low << 8 | high);
        ASSERT_EQ(wire_of(*status), wire);
    }
}

struct my_word {
    std::uint16_t raw;
};
struct my_control_word {
    static constexpr int data_valid = 10;
    std::uint16_t        raw;
};
template <typename Word>
concept controls = requires(Word word) { data_valid(word, reference{}); };
template <typename Word>
concept reports = requires(Word word) { process_status{word, output_frequency{}}; };

TEST(process, takes_the_words_of_a_drive)
{
    VERIFY(drive_word<my_word> and not drive_word<int> and not drive_word<std::uint16_t>);
    VERIFY(data_valid(my_control_word{0x047F}, 50_percent) == data_valid(0x047F, 50_percent));
    VERIFY(data_valid(std::uint16_t{0x047F}, 50_percent) == data_valid(0x047F, 50_percent));
    VERIFY(process_status{my_word{0x0F03}, 50_percent} == process_status{0x0F03, 50_percent});
}

TEST(process, takes_no_status_word_for_a_control_word_nor_the_other_way_round)
{
    VERIFY(controls<my_control_word> and not controls<my_word>);
    VERIFY(reports<my_word> and not reports<my_control_word>);
}

//=== equality ===//

template <typename A, typename B>
concept compares = requires(A const& a, B const& b) { a == b; };

TEST(process, is_equal_by_all_its_words_and_never_to_the_other_direction)
{
    VERIFY(compares<process_command, process_command> and compares<process_status, process_status>);
    VERIFY(not compares<process_command, process_status> and not compares<process_status, process_command>);
    VERIFY(not compares<process_status, basic_process_status<four_words>>);
    VERIFY(process_status(0x0F03, 50_percent) == process_status(0x0F03, 50_percent));
    VERIFY(process_status(0x0F03, 50_percent) != process_status(0x0F02, 50_percent));
    VERIFY(process_status(0x0F03, 50_percent) != process_status(0x0F03, 25_percent));
    VERIFY(process_command{data_not_valid} == data_not_valid and data_valid(0, 0_percent) != data_not_valid);
}

//=== more words ===//

TEST(process, has_as_many_words_as_its_layout)
{
    constexpr std::uint16_t third  = 0x1122;
    constexpr std::int16_t  fourth = -2;
    VERIFY(wire_of(data_valid<four_words>(0x047F, 50_percent, third, fourth)) == "04 7F 20 00 11 22 FF FE"_hex);
    VERIFY(wire_of(basic_process_command<four_words>{data_not_valid}) == "00 00 00 00 00 00 00 00"_hex);
    VERIFY(wire_of(basic_process_status<four_words>{0x0F03, 50_percent, third, fourth})
           == "0F 03 20 00 11 22 FF FE"_hex);
    VERIFY(wire_of(data_valid<four_words>(my_control_word{0x047F}, 50_percent, fourth, third))
           == "04 7F 20 00 FF FE 11 22"_hex);
    VERIFY(basic_process_status<four_words>{my_word{0x0F03}, 50_percent, fourth, third}.pcd(3) == 0x1122);
    VERIFY(basic_process_status<most_words>::wire_size() == 32);
}

template <typename Layout, typename... More>
concept takes = requires(More... more) { data_valid<Layout>(std::uint16_t{}, reference{}, more...); };

TEST(process, takes_no_other_number_of_words)
{
    using u16 = std::uint16_t;
    VERIFY(takes<vlt_layout> and not takes<vlt_layout, u16>);
    VERIFY(takes<four_words, u16, u16> and takes<four_words, std::int16_t, u16>);
    VERIFY(not takes<four_words> and not takes<four_words, u16> and not takes<four_words, u16, u16, u16>);
    VERIFY(not takes<four_words, u16, int> and not takes<four_words, std::uint32_t, u16>);
    VERIFY(not takes<four_words, u16, bool> and not takes<four_words, double, u16>);
}

template <typename Block>
void refuses_every_other_size()
{
    for (std::size_t size = 0; size <= 40; ++size) {
        std::vector<std::uint8_t> const wire(size);
        auto const                      read   = drivecodec::decode<Block>(wire);
        auto const                      wanted = Block::wire_size();
        ASSERT_EQ(read.has_value(), size == wanted) << size;
        if (size < wanted) { ASSERT_EQ(read.error(), error(errc::truncated, wanted)); }
        if (size > wanted) { ASSERT_EQ(read.error(), error(errc::trailing_bytes, wanted)); }
    }
}

TEST(process, refuses_every_other_size)
{
    refuses_every_other_size<process_command>();
    refuses_every_other_size<process_status>();
    refuses_every_other_size<basic_process_command<four_words>>();
    refuses_every_other_size<basic_process_status<most_words>>();
}

template <typename Block>
void survives()
{
    std::mt19937                                 random{3};
    std::array<std::uint8_t, Block::wire_size()> wire{};
    for (int round = 0; round < 1000; ++round) {
        for (auto& byte : wire) { byte = static_cast<std::uint8_t>(random()); }
        auto const read = drivecodec::decode<Block>(wire);
        ASSERT_TRUE(read);
        ASSERT_EQ(wire_of(*read), wire);
        for (std::size_t i = 0; i < Block::wire_size() / 2; ++i) {
            ASSERT_EQ(read->pcd(i), wire[2 * i] << 8 | wire[2 * i + 1]);
            ASSERT_EQ(read->pcd()[i], read->pcd(i));
        }
    }
}

TEST(process, survives_in_every_layout)
{
    survives<process_command>();
    survives<basic_process_command<four_words>>();
    survives<basic_process_status<data_layout<8>>>();
    survives<basic_process_status<most_words>>();
}

}  // namespace
