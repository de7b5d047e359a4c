#include <drivecodec/text/fc/telegram.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <drivecodec/fc/text_requests.hpp>

#include <array>

namespace {

using namespace drivecodec::fc;
using namespace drivecodec::literals;
using drivecodec::bytes;
using drivecodec::describe;

constexpr bool reads(auto const& thing, std::string_view expected)
{
    std::array<char, 200> room{};
    return describe(thing, room) == expected;
}

constexpr auto one = address::short_format(1);

/// A reply with this PKE, PWE, and 0F03 2000.
constexpr parameter_response reply(std::uint16_t pke_raw, std::uint32_t pwe, std::uint16_t ind_raw = 0)
{
    return {pke::from_raw(pke_raw), ind::from_raw(ind_raw), pwe, process_status{0x0F03, 50_percent}};
}

TEST(text_fc_process, shows_all_words)
{
    using six_words = data_layout<6, 12>;
    VERIFY(reads(process_command{data_not_valid}, "PCD 0000 0000"));
    VERIFY(reads(data_valid(0x047F, 50_percent), "PCD 047F 2000"));
    VERIFY(reads(data_valid(0x007F, -100_percent), "PCD 047F C000"));
    VERIFY(reads(process_status{0x0F03, 50_percent}, "PCD 0F03 2000"));
    constexpr std::uint16_t one_more{0xABCD};
    constexpr std::int16_t  minus_2{-2};
    VERIFY(reads(data_valid<six_words>(0x047F, 50_percent, one_more, one_more, minus_2, one_more),
                 "PCD 047F 2000 ABCD ABCD FFFE ABCD"));
}

TEST(text_fc_parameter, shows_the_commands)
{
    VERIFY(reads(no_command(data_not_valid), "no_command, PCD 0000 0000"));
    VERIFY(reads(read_value(202, data_valid(0x047F, 50_percent)), "read_value 202, PCD 047F 2000"));
    VERIFY(reads(read_value(615, std::uint8_t{1}, data_not_valid), "read_value 615[1], PCD 0000 0000"));
    VERIFY(reads(write_word(202, 1000, storage::ram, data_not_valid), "write_word 202 = 1000, PCD 0000 0000"));
    VERIFY(reads(write_word(202, 1000, storage::ram_and_eeprom, data_not_valid),
                 "write_word_to_eeprom 202 = 1000, PCD 0000 0000"));
    VERIFY(reads(write_double_word(500, 100'000U, storage::ram, data_not_valid),
                 "write_double_word 500 = 100000, PCD 0000 0000"));
    VERIFY(reads(write_double_word(500, std::uint8_t{3}, 0xFFFFFFFFU, storage::ram_and_eeprom, data_not_valid),
                 "write_double_word_to_eeprom 500[3] = 4294967295, PCD 0000 0000"));
    VERIFY(reads(any_command(ak_command::read_description, 202, ind::from_raw(7), 0, data_not_valid),
                 "read_description 202[7], PCD 0000 0000"));
}

TEST(text_fc_parameter, shows_the_replies)
{
    VERIFY(reads(reply(0x0000, 0), "no_reply, PCD 0F03 2000"));
    VERIFY(reads(reply(0x10CA, 1000), "word 202 = 1000, PCD 0F03 2000"));
    VERIFY(reads(reply(0x1267, 7, 2), "word 615[2] = 7, PCD 0F03 2000"));
    VERIFY(reads(reply(0x21F4, 100'000), "double_word 500 = 100000, PCD 0F03 2000"));
    VERIFY(reads(reply(0x70CA, 2), "cannot_be_executed 202: value_exceeds_limits (2), PCD 0F03 2000"));
    VERIFY(reads(reply(0x70CA, 0), "cannot_be_executed 202: parameter_does_not_exist (0), PCD 0F03 2000"));
    VERIFY(reads(reply(0x70CA, 100), "cannot_be_executed 202: error 100, PCD 0F03 2000"));
    VERIFY(reads(reply(0x30CA, 0x12345678), "description 202, PWE 12345678, PCD 0F03 2000"));
}

TEST(text_fc_parameter, shows_words_without_a_sign_unless_they_say_that_they_have_one)
{
    VERIFY(reads(reply(0x10CA, 0x0000FFFF), "word 202 = 65535, PCD 0F03 2000"));
    VERIFY(reads(reply(0x10CA, 0xFFFFFFFF), "word 202 = -1, PCD 0F03 2000"));
    VERIFY(reads(reply(0x10CA, 0xFFFF8000), "word 202 = -32768, PCD 0F03 2000"));
    VERIFY(reads(reply(0x10CA, 0xFFFF7FFF), "word 202, PWE FFFF7FFF, PCD 0F03 2000"));
    VERIFY(reads(reply(0x10CA, 0x00010000), "word 202, PWE 00010000, PCD 0F03 2000"));
}

TEST(text_fc_parameter, hides_nothing_of_what_has_no_meaning)
{
    VERIFY(reads(reply(0x50CA, 0), "AK 5 202, PCD 0F03 2000"));
    VERIFY(reads(reply(0xE0CA, 9), "AK 14 202, PWE 00000009, PCD 0F03 2000"));
    VERIFY(reads(reply(0x70CA, 0x00030002),
                 "cannot_be_executed 202: value_exceeds_limits (2), PWE 00030002, PCD 0F03 2000"));
    VERIFY(reads(any_command(ak_command{7}, 202, {}, 2, data_not_valid), "AK 7 202, PWE 00000002, PCD 0000 0000"));
    VERIFY(reads(any_command(ak_command::read_value, 202, {}, 1, data_not_valid),
                 "read_value 202, PWE 00000001, PCD 0000 0000"));
    VERIFY(reads(any_command(ak_command::no_command, 202, {}, 0, data_not_valid), "no_command 202, PCD 0000 0000"));
}

TEST(text_fc_parameter, has_numbers_of_12_bits_in_newer_layouts)
{
    VERIFY(reads(read_value<fc_layout>(4000, data_not_valid), "read_value 4000, PCD 0000 0000"));
    VERIFY(reads(reply(0x18CA, 5), "word 202 = 5, PCD 0F03 2000"));
}

TEST(text_fc_text, shows_what_is_read_and_written)
{
    VERIFY(reads(read_text(621, data_not_valid), "text 621 read, PCD 0000 0000"));
    VERIFY(reads(write_text(533, "HELLO", data_not_valid), "text 533 write \"HELLO\", PCD 0000 0000"));
    VERIFY(reads(write_text(533, "", data_not_valid), "text 533 write \"\", PCD 0000 0000"));

    static constexpr auto name  = "56 4C 54 20 36 30 30 30"_hex;
    static constexpr auto ruins = "22 00 E9"_hex;
    static constexpr auto four  = "41 42 43 44"_hex;
    constexpr auto        heard = [](bytes characters, std::uint16_t ind_raw = 0x0400) {
        return text_response{pke::from_raw(0xF26D), ind::from_raw(ind_raw), characters,
                             process_status{0x0F03, 50_percent}};
    };
    constexpr auto asked = [](bytes characters, std::uint16_t ind_raw) {
        return text_request{pke::from_raw(0xF26D), ind::from_raw(ind_raw), characters, data_not_valid};
    };
    VERIFY(reads(heard(name), "text 621 \"VLT 6000\", PCD 0F03 2000"));
    VERIFY(reads(heard(name, 0x0402), "text 621[2] \"VLT 6000\", PCD 0F03 2000"));
    VERIFY(reads(heard(ruins), "text 621 \"\\\"\\x00\\xE9\", PCD 0F03 2000"));
    VERIFY(reads(heard({}), "text 621 \"\", PCD 0F03 2000"));
    VERIFY(reads(asked(four, 0x0400), "text 621 read \"ABCD\", PCD 0000 0000"));
    VERIFY(reads(asked(four, 0x0000), "text 621 none \"ABCD\", PCD 0000 0000"));
    VERIFY(reads(asked(four, 0x0700), "text 621 access 07 \"ABCD\", PCD 0000 0000"));
}

TEST(text_fc_telegram, says_first_which_way_it_goes)
{
    VERIFY(reads(telegram<process_command>{one, data_valid(0x047F, 50_percent)}, "request to slave 1: PCD 047F 2000"));
    VERIFY(reads(telegram<process_status>{one, {0x0F03, 50_percent}}, "response from slave 1: PCD 0F03 2000"));
    VERIFY(reads(telegram<parameter_request>{one, read_value(202, data_valid(0x047F, 50_percent))},
                 "request to slave 1: read_value 202, PCD 047F 2000"));
    VERIFY(reads(telegram<parameter_response>{address::long_format(126), reply(0x10CA, 1000)},
                 "response from slave 126: word 202 = 1000, PCD 0F03 2000"));
    VERIFY(reads(telegram<basic_fixed_text_request<vlt_layout, 2>>{one, write_text(533, "HI", data_not_valid)},
                 "request to slave 1: text 533 write \"HI\", PCD 0000 0000"));
    VERIFY(reads(telegram<text_response>{one, {pke::from_raw(0xF26D), {}, {}, process_status{}}},
                 "response from slave 1: text 621 \"\", PCD 0000 0000"));
}

TEST(text_fc_telegram, is_a_request_if_it_is_a_broadcast)
{
    VERIFY(
        reads(telegram<process_command>{short_broadcast, data_valid(0x043C, 0_percent)}, "broadcast: PCD 043C 0000"));
    VERIFY(reads(telegram<process_status>{long_broadcast, {}}, "response from broadcast: PCD 0000 0000"));
}

}  // namespace
