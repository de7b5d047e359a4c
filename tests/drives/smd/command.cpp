#include <drivecodec/drives/smd/command.hpp>

#include "support/verify.hpp"

#include <bit>

namespace {

using namespace drivecodec::smd;

// smd manual, table 8: the bit of each command.
static_assert(control_word(command::update_buffers) == 1U << 0);
static_assert(control_word(command::lock) == 1U << 1);
static_assert(control_word(command::stop) == 1U << 2);
static_assert(control_word(command::start) == 1U << 3);
static_assert(control_word(command::set_reverse) == 1U << 6);
static_assert(control_word(command::set_forward) == 1U << 7);
static_assert(control_word(command::serial_speed_reference) == 1U << 8);
static_assert(control_word(command::local_speed_reference) == 1U << 9);

constexpr unsigned known_bits = 0x03CF;
constexpr unsigned stop_bit   = 0x0004;

TEST(smd_manual, gives_examples_of_words_in_its_quick_start)
{
    VERIFY(control_word(command::serial_speed_reference) == 0x0100);  // 7.2, "manual mode"
    VERIFY(control_word(command::stop) == 0x0004);                    // 7.3, from here on
    VERIFY(control_word(command::start) == 0x0008);
    VERIFY(control_word(command::set_reverse) == 0x0040);
    VERIFY(control_word(command::set_forward) == 0x0080);
    VERIFY(control_word(command::lock) == 2);  // 4.8, "writing a 2 to Register #1"
}

TEST(smd_manual, has_one_bit_for_the_serial_reference_of_many_names)
{
    // "Serial speed reference", "manual mode" that obeys the "keypad speed register": bit 8, and no other.
    VERIFY(*decode_command(0x0100) == command::serial_speed_reference);
}

TEST(smd_manual, lets_stop_win_silently_among_several_bits_and_refuses_several_without_it)
{
    VERIFY(*executed_command(0x000C) == command::stop);
    VERIFY(decode_command(0x000C).error() == not_one_command{0x000C, command_fault::several_with_stop});
    VERIFY(executed_command(0x0048).error() == not_one_command{0x0048, command_fault::several});
    VERIFY(decode_command(0x0048).error() == not_one_command{0x0048, command_fault::several});
}

TEST(smd_manual, leaves_bits_10_to_15_blank_and_no_command_has_one)
{
    for (auto const code : command_codes) { EXPECT_EQ(code & 0xFC30U, 0U); }
    for (unsigned bit : {4U, 5U, 10U, 11U, 12U, 13U, 14U, 15U}) {
        auto const raw = static_cast<std::uint16_t>(1U << bit);
        EXPECT_EQ(decode_command(raw).error(), (not_one_command{raw, command_fault::unused_bit}));
    }
}

TEST(smd_command, is_one_bit_with_a_meaning_and_every_other_word_keeps_its_bits)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word    = static_cast<std::uint16_t>(raw);
        auto const decoded = decode_command(word);
        auto const bits    = std::popcount(raw);
        ASSERT_EQ(decoded.has_value(), bits == 1 and (raw & known_bits) != 0) << raw;
        if (decoded) {
            ASSERT_EQ(static_cast<unsigned>(*decoded), raw);
            continue;
        }
        ASSERT_EQ(decoded.error().raw, raw);
        ASSERT_EQ(decoded.error().why, bits == 0                ? command_fault::no_command
                                       : bits == 1              ? command_fault::unused_bit
                                       : (raw & stop_bit) != 0U ? command_fault::several_with_stop
                                                                : command_fault::several)
            << raw;
    }
}

TEST(smd_command, is_carried_out_alone_or_as_a_stop)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word     = static_cast<std::uint16_t>(raw);
        auto const executed = executed_command(word);
        if ((raw & stop_bit) != 0) {
            ASSERT_EQ(*executed, command::stop) << raw;
        } else {
            ASSERT_EQ(executed, decode_command(word)) << raw;
        }
    }
}

TEST(smd_command, has_a_code_for_each_in_ascending_order)
{
    unsigned all  = 0;
    unsigned last = 0;
    for (auto const code : command_codes) {
        EXPECT_GT(code, last);
        EXPECT_TRUE(decode_command(code));
        last = code;
        all |= code;
    }
    EXPECT_EQ(all, known_bits);
}

}  // namespace
