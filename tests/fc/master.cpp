#include <drivecodec/fc/master.hpp>

#include "support/fc_model.hpp"
#include "support/fc_vectors.hpp"
#include "support/verify.hpp"

#include <drivecodec/fc/text_requests.hpp>

namespace {

using namespace drivecodec::literals;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using drivecodec::same_bytes;
using namespace drivecodec::fc;
using fc_model::byte_list;
using fc_model::telegram_of;
using fc_model::with_byte;

constexpr auto one        = address::short_format(1);
constexpr auto one_long   = address::long_format(1);
constexpr auto twenty_two = address::short_format(22);
constexpr auto forwards   = data_valid(0x047F, 50_percent);

constexpr auto read_206    = read_value(206, data_not_valid);
constexpr auto write_202   = write_word(202, 1000, storage::ram_and_eeprom, forwards);
constexpr auto read_615_1  = read_value(615, 1, data_not_valid);
constexpr auto write_291_1 = write_double_word(291, 1, 0x12345, storage::ram_and_eeprom, data_not_valid);
constexpr auto read_621    = read_text(621, data_not_valid);

constexpr reply_error fault(errc code, std::size_t offset)
{
    return error{code, offset};
}

constexpr auto another_reply = fault(errc::unexpected_reply, 3);

//=== the right reply ===//

TEST(master, takes_the_replies_of_the_examples)
{
    static constexpr auto ramp = check(one, read_206, vectors::read_206_response);
    VERIFY(*ramp->value<std::uint16_t>() == 10);
    VERIFY(ramp->process.status_word() == 0x0F03);
    VERIFY(*check(one, write_202, vectors::write_202_response)->value<std::uint16_t>() == 1000);
    VERIFY(*check(one, write_word(415, 20, storage::ram_and_eeprom, data_not_valid), vectors::write_415_response)
                ->value<std::uint8_t>()
           == 20);
    VERIFY(*check(one, read_615_1, vectors::read_615_1_response)->value<std::uint8_t>() == 13);
    VERIFY(*check(one, write_291_1, vectors::write_291_1_response)->value<std::uint32_t>() == 0x12345);
}

TEST(master, takes_process_data)
{
    static constexpr auto status = check(twenty_two, forwards, vectors::status_of_22);
    VERIFY(status->status_word() == 0x0F03);
    VERIFY(*status->output_frequency().frequency(0_Hz, 50_Hz) == 25_Hz);
}

TEST(master, takes_a_text_of_any_length)
{
    static constexpr auto text = check(one_long, read_621, vectors::read_621_response);
    VERIFY(same_bytes(text->characters, "56 4C 54 36 30 30 30"_hex));

    for (std::size_t size = 0; size <= 244; ++size) {
        byte_list data{0xF2, 0x6D, 0x04, 0x00};
        data.resize(4 + size + 4, 'x');
        auto const wire = telegram_of(0x81, data);
        auto const said = check(one_long, read_621, bytes{wire});
        ASSERT_TRUE(said) << size;
        ASSERT_EQ(said->characters.size(), size);
        ASSERT_EQ(said->characters.data(), wire.data() + 7);
    }
}

TEST(master, takes_the_answer_to_a_text_written)
{
    static constexpr auto hello = write_text(533, "HELLO", data_not_valid);
    EXPECT_TRUE(check(one_long, hello, vectors::write_533));
    static constexpr auto letters = "48 45"_hex;
    auto const            made    = *make_write_text(533, letters, data_not_valid);
    EXPECT_TRUE(check(one_long, made, vectors::write_533));
}

//=== no reply ===//

TEST(master, expects_no_reply_to_a_broadcast)
{
    for (unsigned adr = 0; adr < 256; ++adr) {
        auto const to   = address::from_byte(static_cast<std::uint8_t>(adr));
        auto const wire = with_byte(vectors::read_206_response, 2, adr);
        auto const said = check(to, read_206, wire);
        ASSERT_EQ(expects_reply(to), not to.is_broadcast());
        if (to.is_broadcast()) {
            ASSERT_EQ(said.error(), fault(errc::no_reply, 0)) << adr;
        } else if (to.is_reserved()) {
            ASSERT_EQ(said.error(), fault(errc::reserved_address, 2)) << adr;
        } else {
            ASSERT_TRUE(said) << adr;
        }
    }
    VERIFY(check(short_broadcast, forwards, bytes{}).error() == fault(errc::no_reply, 0));
    VERIFY(check(long_broadcast, read_621, bytes{}).error() == fault(errc::no_reply, 0));
}

//=== another slave, or damage ===//

TEST(master, refuses_the_reply_of_every_other_slave)
{
    for (unsigned adr = 0; adr < 256; ++adr) {
        if (address::from_byte(static_cast<std::uint8_t>(adr)).is_reserved()) { continue; }
        auto const wanted = adr == 0x01 ? error{} : error{errc::unexpected_server, 2};
        auto const value  = check(one, read_206, with_byte(vectors::read_206_response, 2, adr));
        ASSERT_EQ(value.has_value(), wanted.ok()) << adr;
        if (not value) { ASSERT_EQ(value.error(), reply_error{wanted}) << adr; }
        auto const status = check(one, forwards, with_byte(vectors::status_of_22, 2, adr));
        ASSERT_EQ(status.has_value(), wanted.ok()) << adr;
        if (not status) { ASSERT_EQ(status.error(), reply_error{wanted}) << adr; }
    }
}

TEST(master, refuses_the_reply_of_the_same_number_in_the_other_format)
{
    VERIFY(check(one_long, read_206, vectors::read_206_response).error() == fault(errc::unexpected_server, 2));
    VERIFY(check(one, read_621, vectors::read_621_response).error() == fault(errc::unexpected_server, 2));
}

template <typename Request>
void refuses_every_wrong_bit_and_every_part(address to, Request const& asked, bytes whole)
{
    ASSERT_TRUE(check(to, asked, whole));
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        byte_list damaged{whole.begin(), whole.end()};
        damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        auto const said = check(to, asked, bytes{damaged});
        ASSERT_FALSE(said) << bit;
        if (bit < 8) { ASSERT_EQ(said.error(), fault(errc::bad_start, 0)); }
        if (bit >= 16) { ASSERT_EQ(said.error(), fault(errc::bad_checksum, whole.size() - 1)) << bit; }
    }
    for (std::size_t size = 0; size < whole.size(); ++size) {
        auto const said = check(to, asked, whole.first(size));
        ASSERT_FALSE(said);
        ASSERT_EQ(said.error().code(), errc::truncated) << size;
        ASSERT_GT(said.error().offset(), size);
        ASSERT_LE(said.error().offset(), whole.size());
    }
    byte_list longer{whole.begin(), whole.end()};
    longer.push_back(0);
    ASSERT_EQ(check(to, asked, bytes{longer}).error(), fault(errc::trailing_bytes, whole.size()));
}

TEST(master, refuses_every_wrong_bit_and_every_part_of_a_reply)
{
    refuses_every_wrong_bit_and_every_part(one, read_206, vectors::read_206_response);
    refuses_every_wrong_bit_and_every_part(one, write_202, vectors::write_202_response);
    refuses_every_wrong_bit_and_every_part(one, read_615_1, vectors::read_615_1_response);
    refuses_every_wrong_bit_and_every_part(one, write_291_1, vectors::write_291_1_response);
    refuses_every_wrong_bit_and_every_part(one_long, read_621, vectors::read_621_response);
    refuses_every_wrong_bit_and_every_part(twenty_two, forwards, vectors::status_of_22);
}

//=== another question ===//

byte_list parameter_reply(unsigned pke, unsigned ind, std::uint32_t pwe)
{
    std::array<std::uint32_t, 6> const words{pke, ind, pwe >> 16, pwe, 0x0F03, 0x2000};
    byte_list                          data;
    for (auto const word : words) {
        data.push_back(static_cast<std::uint8_t>(word >> 8));
        data.push_back(static_cast<std::uint8_t>(word));
    }
    return telegram_of(1, data);
}

/// Which AK answers which: the manual's two tables, side by side. A read may bring either width.
bool may_answer(unsigned command, unsigned reply)
{
    switch (command) {
    case 0x0: return reply == 0x0;
    case 0x1: return reply == 0x1 or reply == 0x2;
    case 0x2:
    case 0xE: return reply == 0x1;
    case 0x3:
    case 0xD: return reply == 0x2;
    case 0x4: return reply == 0x3;  // newer guides
    default: return reply != 0xF;   // 5 to C: undefined
    }
}

// The manual does not show what answers AK D and E, nor what 4 to C are.
TEST(master, takes_every_reply_that_may_answer_a_command_and_no_other)
{
    for (unsigned command = 0; command < 15; ++command) {
        auto const asked = any_command(static_cast<ak_command>(command), 202, {}, 0, data_not_valid);
        for (unsigned reply = 0; reply < 16; ++reply) {
            auto const said = check(one, asked, bytes{parameter_reply(reply << 12 | 202, 0, 5)});
            if (reply == 7) {
                ASSERT_EQ(said.error(), reply_error{parameter_error{5}}) << command;
                continue;
            }
            ASSERT_EQ(said.has_value(), may_answer(command, reply)) << command << " by " << reply;
            if (not said) { ASSERT_EQ(said.error(), another_reply); }
        }
    }
}

TEST(master, refuses_a_word_for_a_double_word_and_the_other_way_round)
{
    EXPECT_EQ(check(one, write_word(202, 1, storage::ram, forwards), bytes{parameter_reply(0x20CA, 0, 1)}).error(),
              another_reply);
    EXPECT_EQ(check(one, write_202, bytes{parameter_reply(0x20CA, 0, 1000)}).error(), another_reply);
    EXPECT_EQ(
        check(one, write_double_word(202, 1, storage::ram, forwards), bytes{parameter_reply(0x10CA, 0, 1)}).error(),
        another_reply);
    EXPECT_EQ(check(one, write_291_1, bytes{parameter_reply(0x1123, 1, 0x12345)}).error(), another_reply);
}

TEST(master, refuses_every_other_parameter)
{
    for (unsigned number = 0; number < 4096; ++number) {
        auto const said = check(one, read_206, bytes{parameter_reply(0x1000 | number, 0, 10)});
        ASSERT_EQ(said.has_value(), number % 2048 == 206) << number;  // bit 11 is no part of the number
        if (not said) { ASSERT_EQ(said.error(), another_reply); }

        auto const newer =
            check(one, read_value<fc_layout>(206, data_not_valid), bytes{parameter_reply(0x1000 | number, 0, 10)});
        ASSERT_EQ(newer.has_value(), number == 206) << number;

        auto const refused = check(one, read_206, bytes{parameter_reply(0x7000 | number, 0, 130)});
        ASSERT_EQ(refused.error(), number % 2048 == 206 ? reply_error{parameter_error{130}} : another_reply) << number;
    }
}

TEST(master, refuses_every_other_element)
{
    for (unsigned index = 0; index < 256; ++index) {
        auto const said = check(one, read_615_1, bytes{parameter_reply(0x1267, index, 13)});
        ASSERT_EQ(said.has_value(), index == 1 or index == 0) << index;  // the manual does not say that it is repeated
        if (not said) { ASSERT_EQ(said.error(), fault(errc::unexpected_reply, 5)); }

        auto const single = check(one, read_206, bytes{parameter_reply(0x10CE, index, 10)});
        ASSERT_EQ(single.has_value(), index == 0) << index;
    }
    EXPECT_TRUE(check(one, read_615_1, bytes{parameter_reply(0x1267, 0x0401, 13)}));  // the high byte is for texts
}

// AK 0 is "no command" one way and "no reply" the other: a telegram does come back.
TEST(master, waits_for_a_telegram_also_for_no_command_though_ak_0_is_called_no_reply)
{
    static constexpr auto asked = no_command(forwards);
    VERIFY(expects_reply(one));
    EXPECT_TRUE(check(one, asked, bytes{parameter_reply(0x0000, 0, 0)}));
    EXPECT_TRUE(check(one, asked, bytes{parameter_reply(0x00CA, 0, 0)})) << "it has no number";
    EXPECT_EQ(check(one, asked, bytes{parameter_reply(0x1000, 0, 0)}).error(), another_reply);
}

// Nothing in a telegram tells which way it goes: the caller has to take out what it hears of itself.
TEST(master, cannot_tell_the_echo_of_a_read_or_of_process_data_from_a_reply)
{
    EXPECT_EQ(*check(one, read_206, vectors::read_206)->value<std::uint16_t>(), 0);
    EXPECT_TRUE(check(one_long, read_621, vectors::read_621));
    EXPECT_EQ(check(twenty_two, forwards, vectors::forwards_to_22)->status_word(), 0x047F);
    EXPECT_EQ(check(one, write_202, vectors::write_202).error(), another_reply);  // no reply has AK E
}

//=== cannot be executed ===//

TEST(master, is_told_every_error_number)
{
    static constexpr auto refused =
        check(one, write_word(501, 5, storage::ram_and_eeprom, data_not_valid), vectors::write_501_response);
    VERIFY(refused.error().code() == errc::exception_reply);
    VERIFY(refused.error().number() == parameter_error::no_bus_access);

    for (unsigned number = 0; number <= 0xFFFF; ++number) {
        auto const said = check(one, read_206, bytes{parameter_reply(0x70CE, 0, number)});
        ASSERT_FALSE(said) << number;
        ASSERT_EQ(said.error().code(), errc::exception_reply);
        ASSERT_EQ(static_cast<unsigned>(said.error().number()), number);
    }
}

TEST(master, is_told_that_a_text_cannot_be_read)
{
    auto wire = parameter_reply(0x726D, 0x0400, 15);
    wire      = with_byte(wire, 2, 0x81);
    EXPECT_EQ(check(one_long, read_621, bytes{wire}).error(), reply_error{parameter_error::no_text});
}

TEST(master, finds_no_error_number_in_what_is_no_parameter_telegram)
{
    for (std::size_t size = 8; size <= 252; ++size) {
        byte_list data(size, 0x00);
        data[0]         = 0x72;
        data[1]         = 0x6D;
        data[7]         = 130;
        auto const wire = telegram_of(0x81, data);
        auto const said = check(one_long, read_621, bytes{wire});
        ASSERT_EQ(said.error(), size == 12 ? reply_error{parameter_error::no_bus_access} : another_reply) << size;
    }
}

//=== another kind of telegram ===//

TEST(master, refuses_a_text_for_a_parameter)
{
    byte_list data{0xF0, 0xCE, 0x04, 0x00, 'A', 'B', 'C', 'D', 0, 0, 0, 0};
    EXPECT_EQ(check(one, read_206, bytes{telegram_of(1, data)}).error(), another_reply);
    data.push_back(0);
    EXPECT_EQ(check(one, read_206, bytes{telegram_of(1, data)}).error(), fault(errc::bad_length, 1));
}

TEST(master, refuses_a_parameter_for_a_text)
{
    for (unsigned reply = 0; reply < 15; ++reply) {
        if (reply == 7) { continue; }
        auto const wire = with_byte(parameter_reply(reply << 12 | 621, 0, 5), 2, 0x81);
        EXPECT_EQ(check(one_long, read_621, bytes{wire}).error(), another_reply) << reply;
    }
    auto const other = with_byte(vectors::read_621_response, 4, 0x6E);  // 622
    EXPECT_EQ(check(one_long, read_621, bytes{other}).error(), another_reply);
}

TEST(master, refuses_process_data_for_a_parameter_and_the_other_way_round)
{
    VERIFY(check(twenty_two, read_206, vectors::status_of_22).error() == fault(errc::bad_length, 1));
    VERIFY(check(twenty_two, read_621, vectors::status_of_22).error() == fault(errc::bad_length, 1));
    VERIFY(check(one, forwards, vectors::read_206_response).error() == fault(errc::bad_length, 1));
}

//=== layouts ===//

TEST(master, checks_in_the_layout_of_the_request)
{
    using wide       = data_layout<4, 12>;
    auto const asked = read_value<wide>(4000, data_not_valid);
    auto const wire  = telegram_of(1, "1F A0 00 00 00 00 12 34 0F 03 20 00 00 07 00 08"_hex);
    auto const said  = check(one, asked, bytes{wire});
    ASSERT_TRUE(said);
    EXPECT_EQ(*said->value<std::uint16_t>(), 0x1234);
    EXPECT_EQ(said->process.pcd(3), 8);
    EXPECT_EQ(check(one, asked, vectors::read_206_response).error(), fault(errc::bad_length, 1));

    auto const text = read_text<wide>(4000, data_not_valid);
    auto const none = telegram_of(1, "7F A0 00 00 00 00 12 34 0F 03 20 00"_hex);  // has no PWE
    EXPECT_EQ(check(one, text, bytes{none}).error(), another_reply);
    auto const refused = telegram_of(1, "7F A0 00 00 00 00 00 0F 0F 03 20 00 00 00 00 00"_hex);
    EXPECT_EQ(check(one, text, bytes{refused}).error(), reply_error{parameter_error::no_text});
}

TEST(master, knows_what_is_a_request)
{
    VERIFY(request<process_command> and request<parameter_request> and request<text_request>);
    VERIFY(not request<process_status> and not request<parameter_response> and not request<text_response>);
}

}  // namespace
