#include <drivecodec/drives/smd/status_block.hpp>

#include "support/verify.hpp"

#include <vector>

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::smd;

using six_words = std::array<std::uint16_t, 6>;

/// As the manual's table 10 has the twelve bytes: D1H D1L to D6H D6L.
constexpr std::array<std::uint8_t, 12> wire{0x02, 0x01, 0x01, 0xF4, 0x64, 0x06, 0x01, 0x0B, 0x06, 0x00, 0x18, 0x00};
constexpr status_block                 running{.command_speed       = {513, -1},
                                               .actual_speed        = {500, -1},
                                               .load                = {100, 0},
                                               .operational_status  = operational_status::run,
                                               .actual_direction    = direction::reverse,
                                               .control_mode        = control_mode::c40_modbus,
                                               .speed_source        = speed_source::serial,
                                               .speed_reference     = speed_reference::serial,
                                               .fault               = fault::communication_fault,
                                               .commanded_direction = direction::forward};

constexpr status_block decoded(six_words words)
{
    return *status_block::decode(words);
}

TEST(smd_status_block, is_six_words_of_twelve_bytes)
{
    VERIFY(status_block::decode(modbus::register_view::of_wire(wire)) == running);
    VERIFY(status_block::address == 24 and status_block::word_count == 6);
}

TEST(smd_manual, calls_a_command_speed_of_0201_hexadecimal_51_3_hertz_and_a_load_of_64_100_percent)
{
    constexpr auto given = decoded({0x0201, 0, 0x6400, 0, 0, 0});
    VERIFY(given.command_speed == 51.3_Hz);
    VERIFY(given.load == 100_percent);
}

TEST(smd_status_block, has_each_thing_in_its_own_byte)
{
    VERIFY(decoded({0, 0, 0, 0, 0, 0}) == status_block{});
    VERIFY(status_block{}.command_speed.exponent == -1 and status_block{}.actual_speed.exponent == -1);
    VERIFY(status_block{}.load.exponent == 0);
    VERIFY(decoded({2400, 0, 0, 0, 0, 0}) == status_block{.command_speed = 240.0_Hz});
    VERIFY(decoded({0, 2400, 0, 0, 0, 0}) == status_block{.actual_speed = 240.0_Hz});
    VERIFY(decoded({0, 0, 0x0100, 0, 0, 0}) == status_block{.load = 1_percent});
    VERIFY(decoded({0, 0, 0x000C, 0, 0, 0}) == status_block{.operational_status = operational_status::off});
    VERIFY(decoded({0, 0, 0, 0x0100, 0, 0}) == status_block{.actual_direction = direction::reverse});
    VERIFY(decoded({0, 0, 0, 0x000A, 0, 0}) == status_block{.control_mode = control_mode::analog_modbus});
    VERIFY(decoded({0, 0, 0, 0, 0x0500, 0}) == status_block{.speed_source = speed_source::mop});
    VERIFY(decoded({0, 0, 0, 0, 0x0001, 0}) == status_block{.speed_reference = speed_reference::local});
    VERIFY(decoded({0, 0, 0, 0, 0, 0x1A00}) == status_block{.fault = fault::configuration_fault});
    VERIFY(decoded({0, 0, 0, 0, 0, 0x0001}) == status_block{.commanded_direction = direction::reverse});
}

TEST(smd_manual, has_no_signed_numbers_so_a_speed_and_its_direction_are_two_things)
{
    constexpr auto backwards = decoded({0xFFFF, 0xFFFF, 0, 0x0100, 0, 0x0001});
    VERIFY(backwards.command_speed == 6553.5_Hz and backwards.actual_speed == 6553.5_Hz);
    VERIFY(backwards.actual_direction == direction::reverse and backwards.commanded_direction == direction::reverse);
}

TEST(smd_status_block, of_any_six_words_comes_back_as_it_was)
{
    for (std::size_t at = 0; at < status_block::word_count; ++at) {
        for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
            for (auto const others : std::array<std::uint16_t, 3>{0x0000, 0xFFFF, 0x5A3C}) {
                six_words words{others, others, others, others, others, others};
                words[at]        = static_cast<std::uint16_t>(raw);
                auto const block = status_block::decode(words);
                ASSERT_TRUE(block);
                auto const back = block->make_words();
                ASSERT_TRUE(back);
                ASSERT_EQ(back->words, words) << at;
            }
        }
    }
    VERIFY(decoded({1, 2, 3, 4, 5, 6}).make_words()->words == six_words{1, 2, 3, 4, 5, 6});
}

TEST(smd_status_block, is_what_reads_of_the_single_registers_say)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word  = static_cast<std::uint16_t>(raw);
        auto const block = status_block::from_words({word, word, word, word, word, word});
        ASSERT_EQ(block.command_speed.number, word);
        ASSERT_EQ(block.actual_speed.number, word);
        ASSERT_EQ(block.load, load_and_status::from_raw(word).load());
        ASSERT_EQ(block.operational_status, load_and_status::from_raw(word).get(load_and_status::operational_status));
        ASSERT_EQ(block.fault, fault_and_direction::from_raw(word).get(fault_and_direction::fault));
    }
}

TEST(smd_status_block, of_any_other_number_of_words_is_refused)
{
    for (std::size_t count = 0; count < 20; ++count) {
        std::vector<std::uint16_t> const words(count);
        auto const                       block = status_block::decode(words);
        EXPECT_EQ(block.has_value(), count == 6);
        if (count != 6) { EXPECT_EQ(block.error(), (error{errc::bad_quantity, 0})); }
    }
}

TEST(smd_status_block, with_what_its_words_cannot_hold_is_refused_at_the_word)
{
    constexpr auto refused = [](status_block const& given) { return given.make_words().error(); };
    VERIFY(refused({.command_speed = 51.35_Hz}) == error{errc::inexact, 0});
    VERIFY(refused({.actual_speed = 51.35_Hz}) == error{errc::inexact, 1});
    VERIFY(refused({.load = 0.5_percent}) == error{errc::inexact, 2});
    VERIFY(refused({.command_speed = {-1, -1}}) == error{errc::out_of_range, 0});
    VERIFY(refused({.command_speed = 6553.6_Hz}) == error{errc::out_of_range, 0});
    VERIFY(refused({.actual_speed = {-1, -1}}) == error{errc::out_of_range, 1});
    VERIFY(refused({.actual_speed = 6553.6_Hz}) == error{errc::out_of_range, 1});
    VERIFY(refused({.load = 256_percent}) == error{errc::out_of_range, 2});
    VERIFY(refused({.load = {-1, 0}}) == error{errc::out_of_range, 2});
    VERIFY(refused({.control_mode = smd::control_mode{256}}) == error{errc::out_of_range, 3});
    VERIFY(refused({.fault = smd::fault{256}}) == error{errc::out_of_range, 5});
}

TEST(smd_status_block, takes_speeds_of_any_scale)
{
    VERIFY(status_block{.command_speed = 50_Hz, .actual_speed = 0.05_kHz}.make_words()->words
           == six_words{500, 500, 0, 0, 0, 0});
}

}  // namespace
