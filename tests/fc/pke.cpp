#include <drivecodec/fc/pke.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::errc;
using drivecodec::error;
using namespace drivecodec::fc;
using newer_number = basic_parameter_number<fc_layout>;

constexpr std::uint16_t raw_of(parameter_number constant, ak_command command)
{
    return constant.with(command).raw;
}

// VLT 6000 manual, "Parameter commands and replies (AK)".
TEST(pke, has_the_commands_and_replies_of_the_manual)
{
    VERIFY(ak_command{0b0000} == ak_command::no_command);
    VERIFY(ak_command{0b0001} == ak_command::read_value);
    VERIFY(ak_command{0b0010} == ak_command::write_word);
    VERIFY(ak_command{0b0011} == ak_command::write_double_word);
    VERIFY(ak_command{0b1101} == ak_command::write_double_word_to_eeprom);
    VERIFY(ak_command{0b1110} == ak_command::write_word_to_eeprom);
    VERIFY(ak_command{0b1111} == ak_command::text);

    VERIFY(ak_reply{0b0000} == ak_reply::no_reply);
    VERIFY(ak_reply{0b0001} == ak_reply::word);
    VERIFY(ak_reply{0b0010} == ak_reply::double_word);
    VERIFY(ak_reply{0b0111} == ak_reply::cannot_be_executed);
    VERIFY(ak_reply{0b1111} == ak_reply::text);
}

TEST(pke, has_the_commands_of_newer_guides)
{
    VERIFY(ak_command{4} == ak_command::read_description);
    VERIFY(ak_reply{3} == ak_reply::description);
}

// The PKEs that the manual prints.
TEST(pke, is_the_one_of_the_examples)
{
    VERIFY(raw_of(615, ak_command::read_value) == 0x1267);
    VERIFY(raw_of(202, ak_command::write_word_to_eeprom) == 0xE0CA);
    VERIFY(raw_of(206, ak_command::read_value) == 0x10CE);
    VERIFY(raw_of(415, ak_command::write_word_to_eeprom) == 0xE19F);
    VERIFY(pke::from_raw(0x119F).number() == 415);
    VERIFY(pke::from_raw(0x119F).get(pke::reply) == ak_reply::word);
    VERIFY(pke::from_raw(0xE19F).get(pke::command) == ak_command::write_word_to_eeprom);
}

TEST(pke, is_read_from_every_word)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const read = pke::from_raw(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(static_cast<unsigned>(read.get(pke::command)), raw / 0x1000);
        ASSERT_EQ(static_cast<unsigned>(read.get(pke::reply)), raw / 0x1000);
        ASSERT_EQ(read.number(), raw % 0x800);
        ASSERT_EQ(read.number<vlt_layout>(), raw % 0x800);
        ASSERT_EQ(read.number<fc_layout>(), raw % 0x1000);
        ASSERT_EQ(read.get(pke::number_of_11_bits), raw % 0x800);
        ASSERT_EQ(read.get(pke::number_of_12_bits), raw % 0x1000);
        ASSERT_EQ(read.test(pke::bit_11), raw / 0x800 % 2 == 1);
        ASSERT_EQ(read.raw, raw);
    }
}

// The manual says nothing of bit 11: it belongs to the number in newer guides, and survives here.
TEST(pke, keeps_bit_11_of_which_the_manual_says_nothing)
{
    VERIFY(pke::from_raw(0x18CA).number() == 0x0CA);
    VERIFY(pke::from_raw(0x18CA).number<fc_layout>() == 0x8CA);
    VERIFY(pke::from_raw(0x18CA).test(pke::bit_11));
    VERIFY(pke::from_raw(0x18CA).with(pke::reply, ak_reply::word).raw == 0x18CA);
}

TEST(pke, is_made_of_every_number_and_every_command)
{
    for (unsigned number = 0; number <= 0xFFFF; ++number) {
        auto const given  = static_cast<std::uint16_t>(number);
        auto const eleven = parameter_number::make(given);
        auto const twelve = newer_number::make(given);
        ASSERT_EQ(eleven.has_value(), number <= 2047) << number;
        ASSERT_EQ(twelve.has_value(), number <= 4095) << number;
        if (not eleven) { ASSERT_EQ(eleven.error(), error(errc::bad_value, 0)); }
        if (not twelve) { ASSERT_EQ(twelve.error(), error(errc::bad_value, 0)); }
        for (unsigned ak = 0; ak < 16; ++ak) {
            if (eleven) { ASSERT_EQ(eleven->with(static_cast<ak_command>(ak)).raw, ak * 0x1000 + number); }
            if (twelve) { ASSERT_EQ(twelve->with(static_cast<ak_command>(ak)).raw, ak * 0x1000 + number); }
        }
        if (eleven) { ASSERT_EQ(eleven->number(), number); }
    }
}

TEST(parameter_number, is_a_constant_up_to_the_last)
{
    static constexpr parameter_number first      = 0;
    static constexpr parameter_number last       = 2047;
    static constexpr newer_number     newer_last = 4095;
    VERIFY(first.number() == 0 and last.number() == 2047 and newer_last.number() == 4095);
    VERIFY(parameter_number::last == 2047 and newer_number::last == 4095);
    VERIFY(last == *parameter_number::make(2047));
    VERIFY(last != first);
}

// "Only the lowbyte is used", says the manual under "Index"; for texts it then uses the high byte, 04 or 05.
TEST(ind, has_the_array_index_in_its_low_byte_and_the_access_to_texts_in_the_high_one)
{
    VERIFY(ind::from_raw(0x0001).get(ind::array_index) == 1);
    VERIFY(ind::from_raw(0x0400).get(ind::text_access) == text_access::read);
    VERIFY(ind::from_raw(0x0500).get(ind::text_access) == text_access::write);
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const read = ind::from_raw(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(read.get(ind::array_index), raw % 0x100);
        ASSERT_EQ(static_cast<unsigned>(read.get(ind::text_access)), raw / 0x100);
        ASSERT_EQ(
            ind{}.with(ind::array_index, read.get(ind::array_index)).with(ind::text_access, read.get(ind::text_access)),
            read);
    }
}

}  // namespace
