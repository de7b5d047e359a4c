#include <drivecodec/fc/telegram.hpp>

#include "support/fc_model.hpp"
#include "support/fc_vectors.hpp"
#include "support/verify.hpp"

#include <drivecodec/fc/text_requests.hpp>

#include <random>

namespace {

using namespace drivecodec::literals;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using drivecodec::mutable_bytes;
using drivecodec::same_bytes;
using namespace drivecodec::fc;
using fc_model::byte_list;
using fc_model::telegram_of;

constexpr auto one        = address::short_format(1);
constexpr auto one_long   = address::long_format(1);
constexpr auto twenty_two = address::short_format(22);
constexpr auto forwards   = data_valid(0x047F, 50_percent);
constexpr auto backwards  = data_valid(0x047F, -50_percent);

//=== golden telegrams ===//

TEST(telegram, encodes_the_examples)
{
    VERIFY(encode(one, read_value(206, data_not_valid)) == vectors::read_206);
    VERIFY(encode(one, write_word(202, 1000, storage::ram_and_eeprom, forwards)) == vectors::write_202);
    VERIFY(encode(one, write_word(415, 20, storage::ram_and_eeprom, data_not_valid)) == vectors::write_415);
    VERIFY(encode(one, read_value(615, 1, data_not_valid)) == vectors::read_615_1);
    VERIFY(encode(twenty_two, forwards) == vectors::forwards_to_22);
    VERIFY(encode(twenty_two, backwards) == vectors::backwards_to_22);
    VERIFY(encode(twenty_two, process_status{0x0F03, 50_percent}) == vectors::status_of_22);
    VERIFY(encode(short_broadcast, backwards) == vectors::backwards_to_all_short);
    VERIFY(encode(long_broadcast, backwards) == vectors::backwards_to_all_long);
    VERIFY(encode(one_long, read_text(621, data_not_valid)) == vectors::read_621);
    VERIFY(encode(one_long, write_text(533, "HELLO", data_not_valid)) == vectors::write_533);
    VERIFY(encode(one, write_word(501, 5, storage::ram_and_eeprom, data_not_valid)) == vectors::write_501);
    VERIFY(encode(one, write_double_word(291, 1, 0x12345, storage::ram_and_eeprom, data_not_valid))
           == vectors::write_291_1);
}

TEST(telegram, decodes_the_examples)
{
    static constexpr auto asked = decode<parameter_request>(vectors::write_202);
    VERIFY(asked->address == one);
    VERIFY(asked->data == write_word(202, 1000, storage::ram_and_eeprom, forwards));
    static constexpr auto said = decode<parameter_response>(vectors::write_202_response);
    VERIFY(said->address == one and said->data.number() == 202 and *said->data.value<std::uint16_t>() == 1000);
    static constexpr auto status = decode<process_status>(vectors::status_of_22);
    VERIFY(status->address.number() == 22 and status->data == process_status{0x0F03, 50_percent});
    static constexpr auto text = decode<text_response>(vectors::read_621_response);
    VERIFY(text->address == one_long and text->data.number() == 621);
    VERIFY(same_bytes(text->data.characters, "56 4C 54 36 30 30 30"_hex));
    VERIFY(decode<process_command>(vectors::backwards_to_all_long)->address.is_broadcast());
}

// VLT 6000 manual, "Telegram length (LGE)".
TEST(telegram, has_the_lge_of_the_manual)
{
    VERIFY(encode(one, forwards)[1] == 6 and encode(one, forwards).size() == 8);
    VERIFY(encode(one, read_value(1, forwards))[1] == 14 and encode(one, read_value(1, forwards)).size() == 16);
    VERIFY(encode(one, write_text(533, "HELLO", forwards))[1] == 10 + 5);
    VERIFY(vectors::read_621_response[1] == 10 + 7);
}

// "10 + n" does not hold for what reads a text: it has the four bytes of a value, which are 0.
TEST(telegram, that_reads_a_text_has_lge_14_though_it_has_no_characters)
{
    VERIFY(encode(one, read_text(621, forwards))[1] == 14);
    VERIFY(encode(one, read_text(621, forwards)).size() == 16);
}

TEST(telegram, has_data_between_adr_and_bcc)
{
    VERIFY(same_bytes(data_of(vectors::forwards_to_22), "04 7F 20 00"_hex));
    VERIFY(data_of("02 02 16 16"_hex).empty());
    VERIFY(max_telegram_size == 256 and max_data_size == 252);
}

//=== every bit ===//

/// Is it a telegram of any kind?
bool is_any(bytes wire)
{
    return telegram<process_command>::check(wire).ok() or telegram<parameter_request>::check(wire).ok()
           or telegram<text_request>::check(wire).ok();
}

TEST(telegram, with_a_single_wrong_bit_is_refused_as_any_kind)
{
    for (auto const whole : vectors::all_fc) {
        ASSERT_TRUE(is_any(whole));
        for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
            byte_list damaged{whole.begin(), whole.end()};
            damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
            ASSERT_FALSE(is_any(damaged)) << bit;
            ASSERT_FALSE(check_telegram(damaged, 4, max_data_size).ok()) << bit;
            if (bit >= 16) {
                ASSERT_EQ(check_telegram(damaged, 4, max_data_size), error(errc::bad_checksum, whole.size() - 1))
                    << bit;
            }
        }
    }
}

// An exclusive or cannot see two errors in one column: this is what the protocol promises, and no more.
TEST(telegram, with_two_wrong_bits_in_one_column_is_taken)
{
    for (auto const whole : vectors::all_fc) {
        for (std::size_t first = 3; first < whole.size(); ++first) {
            for (auto second = first + 1; second < whole.size(); ++second) {
                byte_list damaged{whole.begin(), whole.end()};
                damaged[first] ^= 0x10;
                damaged[second] ^= 0x10;
                ASSERT_TRUE(check_telegram(damaged, 4, max_data_size).ok());
                damaged[second] ^= 0x30;  // in two columns instead
                ASSERT_EQ(check_telegram(damaged, 4, max_data_size).code(), errc::bad_checksum);
            }
        }
    }
}

//=== every length ===//

enum class kind { process, parameter, text };

/// What is wrong with LGE `lge` in `size` bytes that are right otherwise: the rule, written a second time.
error lengths_say(kind of, unsigned lge, std::size_t size)
{
    auto const least = of == kind::process ? 6U : of == kind::parameter ? 14U : 10U;
    auto const most  = of == kind::text ? 254U : least;
    if (size < 2) { return {errc::truncated, least + 2}; }
    if (lge < least or lge > most) { return {errc::bad_length, 1}; }
    if (size < lge + 2) { return {errc::truncated, lge + 2}; }
    if (size > lge + 2) { return {errc::trailing_bytes, lge + 2}; }
    return {};
}

TEST(telegram, of_every_lge_and_every_length_is_what_the_rule_says)
{
    for (unsigned lge = 0; lge <= 255; ++lge) {
        for (std::size_t size = 0; size <= 300; ++size) {
            for (auto const of : {kind::process, kind::parameter, kind::text}) {
                byte_list wire(size, 0x00);
                if (size > 0) { wire[0] = 0x02; }
                if (size > 1) { wire[1] = static_cast<std::uint8_t>(lge); }
                if (size > 2) { wire[2] = 0x01; }
                if (size > 3) { wire[3] = of == kind::text ? 0xF2 : 0x12; }
                if (size > 4 and lge + 2 <= size) { wire[lge + 1] ^= fc_model::bcc(bytes{wire}.first(lge + 2)); }

                auto const request  = of == kind::process     ? telegram<process_command>::check(wire)
                                      : of == kind::parameter ? telegram<parameter_request>::check(wire)
                                                              : telegram<text_request>::check(wire);
                auto const response = of == kind::process     ? telegram<process_status>::check(wire)
                                      : of == kind::parameter ? telegram<parameter_response>::check(wire)
                                                              : telegram<text_response>::check(wire);
                ASSERT_EQ(request, lengths_say(of, lge, size)) << lge << " in " << size;
                ASSERT_EQ(response, request) << lge << " in " << size;
            }
        }
    }
}

TEST(telegram, in_other_layouts_has_other_lengths)
{
    using wide = data_layout<4, 12>;
    for (std::size_t size = 0; size <= 252; ++size) {
        byte_list data(size, 0x00);
        if (size > 0) { data[0] = 0xF2; }
        auto const wire = telegram_of(1, data);
        ASSERT_EQ(telegram<basic_process_command<wide>>::check(wire).ok(), size == 8) << size;
        ASSERT_EQ(telegram<basic_text_response<wide>>::check(wire).ok(), size >= 12) << size;
        if (size > 0) { data[0] = 0x12; }
        ASSERT_EQ(telegram<basic_parameter_request<wide>>::check(telegram_of(1, data)).ok(), size == 16) << size;
    }
}

TEST(telegram, says_of_every_prefix_how_long_it_is_at_least)
{
    for (auto const whole : vectors::all_fc) {
        for (std::size_t size = 0; size < whole.size(); ++size) {
            auto const prefix = whole.first(size);
            auto const wanted = error{errc::truncated, size < 2 ? std::size_t{8} : whole.size()};
            ASSERT_EQ(check_telegram(prefix, 4, max_data_size), wanted) << size;
        }
    }
    VERIFY(decode<parameter_request>(bytes{}).error() == error{errc::truncated, 16});
    VERIFY(decode<parameter_request>("02"_hex).error() == error{errc::truncated, 16});
    VERIFY(decode<parameter_request>("02 0E"_hex).error() == error{errc::truncated, 16});
}

TEST(telegram, refuses_what_follows)
{
    for (auto const whole : vectors::all_fc) {
        byte_list longer{whole.begin(), whole.end()};
        longer.push_back(0x02);
        ASSERT_EQ(check_telegram(longer, 4, max_data_size), error(errc::trailing_bytes, whole.size()));
    }
}

TEST(telegram, begins_with_stx_and_nothing_else)
{
    for (unsigned first = 0; first < 256; ++first) {
        auto const wire = fc_model::with_byte(vectors::write_202, 0, first);
        ASSERT_EQ(telegram<parameter_request>::check(wire), first == 2 ? error{} : error(errc::bad_start, 0)) << first;
        ASSERT_EQ(telegram<parameter_request>::check(bytes{wire}.first(1)),
                  first == 2 ? error(errc::truncated, 16) : error(errc::bad_start, 0));
    }
}

TEST(telegram, refuses_every_other_bcc)
{
    byte_list wire{vectors::write_202.begin(), vectors::write_202.end()};
    for (unsigned last = 0; last < 256; ++last) {
        wire.back() = static_cast<std::uint8_t>(last);
        ASSERT_EQ(telegram<parameter_request>::check(wire), last == 0x97 ? error{} : error(errc::bad_checksum, 15));
    }
}

TEST(telegram, takes_every_adr_that_is_not_reserved)
{
    for (unsigned adr = 0; adr < 256; ++adr) {
        auto const wire = fc_model::with_byte(vectors::write_202, 2, adr);
        auto const read = decode<parameter_request>(bytes{wire});
        ASSERT_EQ(read.has_value(), adr != 0x00 and adr != 0x40 and adr != 0xFF) << adr;
        if (not read) {
            ASSERT_EQ(read.error(), error(errc::reserved_address, 2));
            continue;
        }
        ASSERT_EQ(read->address.byte(), adr);
        auto const again = encode(read->address, read->data);
        ASSERT_TRUE(same_bytes(again, wire));
    }
}

// The address is looked at last: with a wrong BCC nobody knows that it was one.
TEST(telegram, with_two_faults_has_the_first_of_them_in_wire_order_and_the_address_last)
{
    VERIFY(decode<process_command>("03 07 00 04 7F 20 00 00"_hex).error() == error{errc::bad_start, 0});
    VERIFY(decode<process_command>("02 07 00 04 7F 20 00 00"_hex).error() == error{errc::bad_length, 1});
    VERIFY(decode<process_command>("02 06 00 04 7F 20 00 00"_hex).error() == error{errc::bad_checksum, 7});
    VERIFY(decode<process_command>("02 06 00 04 7F 20 00 5F"_hex).error() == error{errc::reserved_address, 2});
}

//=== kinds ===//

TEST(telegram, of_12_data_bytes_is_a_text_or_a_parameter_as_ak_says)
{
    VERIFY(decode<parameter_request>(vectors::read_621).error() == error{errc::unexpected_function, 3});
    VERIFY(decode<text_request>(vectors::read_206).error() == error{errc::unexpected_function, 3});
    for (unsigned ak = 0; ak < 16; ++ak) {
        auto const wire = fc_model::with_byte(vectors::read_206, 3, ak << 4);
        ASSERT_EQ(telegram<parameter_request>::check(wire).ok(), ak != 0xF) << ak;
        ASSERT_EQ(telegram<text_request>::check(wire).ok(), ak == 0xF) << ak;
    }
}

//=== round trips ===//

template <typename Data>
void survives(std::size_t least, std::size_t most, unsigned ak_at_most, unsigned ak_at_least)
{
    std::mt19937 random{6};
    for (int round = 0; round < 3000; ++round) {
        byte_list data(least + random() % (most - least + 1));
        for (auto& byte : data) { byte = static_cast<std::uint8_t>(random()); }
        auto const ak = ak_at_least + random() % (ak_at_most - ak_at_least + 1);
        if (most > 32 or ak_at_most < 15) { data[0] = static_cast<std::uint8_t>(ak << 4 | data[0] % 16U); }
        auto const adr  = 1 + random() % 31 + (random() % 2 != 0 ? 0x80 : 0);
        auto const wire = telegram_of(static_cast<int>(adr), data);

        auto const read = decode<Data>(bytes{wire});
        ASSERT_TRUE(read) << static_cast<int>(read.error().code());
        ASSERT_EQ(read->wire_size(), wire.size());
        ASSERT_EQ(read->address.byte(), adr);
        byte_list  buffer(256, 0xEE);
        auto const written = encode(read->address, read->data, buffer);
        ASSERT_TRUE(written);
        ASSERT_TRUE(same_bytes(*written, wire));
        ASSERT_EQ(*read, *decode<Data>(bytes{*written}));
        for (auto i = wire.size(); i < buffer.size(); ++i) { ASSERT_EQ(buffer[i], 0xEE); }
    }
}

template <typename Layout>
void survives_in()
{
    constexpr auto process   = Layout::process_size;
    constexpr auto parameter = Layout::parameter_size;
    survives<basic_process_command<Layout>>(process, process, 15, 0);
    survives<basic_process_status<Layout>>(process, process, 15, 0);
    survives<basic_parameter_request<Layout>>(parameter, parameter, 14, 0);
    survives<basic_parameter_response<Layout>>(parameter, parameter, 14, 0);
    survives<basic_text_request<Layout>>(Layout::around_text, 252, 15, 15);
    survives<basic_text_response<Layout>>(Layout::around_text, 252, 15, 15);
}

TEST(telegram, survives_in_every_kind_direction_and_layout)
{
    survives_in<vlt_layout>();
    survives_in<fc_layout>();
    survives_in<data_layout<4>>();
    survives_in<data_layout<8, 12>>();
    survives_in<data_layout<16>>();
}

//=== buffers ===//

template <typename Data>
void leaves_every_smaller_buffer_untouched(Data const& data, std::size_t needs)
{
    for (std::size_t size = 0; size <= needs + 3; ++size) {
        byte_list  buffer(size, 0xEE);
        auto const written = encode(one, data, buffer);
        ASSERT_EQ(written.has_value(), size >= needs) << size;
        if (written) {
            ASSERT_EQ(written->data(), buffer.data());
            ASSERT_EQ(written->size(), needs);
        } else {
            ASSERT_EQ(written.error(), error(errc::no_space, needs));
        }
        for (auto i = written ? needs : 0; i < size; ++i) { ASSERT_EQ(buffer[i], 0xEE) << i << " of " << size; }
    }
}

TEST(telegram, leaves_every_smaller_buffer_untouched)
{
    leaves_every_smaller_buffer_untouched(forwards, 8);
    leaves_every_smaller_buffer_untouched(process_status{0x0F03, 50_percent}, 8);
    leaves_every_smaller_buffer_untouched(read_value(202, forwards), 16);
    leaves_every_smaller_buffer_untouched(read_text(621, forwards), 16);
    leaves_every_smaller_buffer_untouched(write_text(533, "HELLO", forwards), 17);
    byte_list const characters(244, 'x');
    leaves_every_smaller_buffer_untouched(*make_write_text(533, characters, forwards), 256);
}

TEST(telegram, has_no_more_than_244_characters)
{
    for (std::size_t size = 240; size <= 300; ++size) {
        byte_list const     characters(size, 'x');
        text_response const text{pke::from_raw(0xF26D), ind::from_raw(0x0400), characters, {}};
        byte_list           buffer(400, 0xEE);
        auto const          written = encode(one, text, buffer);
        ASSERT_EQ(written.has_value(), size <= 244) << size;
        if (not written) {
            ASSERT_EQ(written.error(), error(errc::bad_length, 3));
            ASSERT_EQ(buffer, byte_list(400, 0xEE));
        }
    }
}

TEST(telegram, is_sealed_around_data_that_are_there)
{
    VERIFY([] {
        std::array<std::uint8_t, 8> out{0xEE, 0xEE, 0xEE, 0x04, 0x7F, 0x20, 0x00, 0xEE};
        seal(out, twenty_two);
        return out == vectors::forwards_to_22;
    }());
}

}  // namespace
