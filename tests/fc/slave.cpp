#include <drivecodec/fc/slave.hpp>

#include "support/fc_model.hpp"
#include "support/fc_vectors.hpp"
#include "support/verify.hpp"

#include <drivecodec/core/overload.hpp>
#include <drivecodec/fc/master.hpp>
#include <drivecodec/fc/text_requests.hpp>

#include <memory>
#include <random>
#include <string_view>

namespace {

using namespace drivecodec::literals;
using drivecodec::bytes;
using drivecodec::mutable_bytes;
using drivecodec::overload;
using drivecodec::same_bytes;
using namespace drivecodec::fc;
using fc_model::byte_list;
using fc_model::telegram_of;
using fc_model::with_byte;

constexpr auto one      = address::short_format(1);
constexpr auto forwards = data_valid(0x047F, 50_percent);

constexpr process_status running{0x0F03, 50_percent};

[[nodiscard]] byte_list characters_of(std::string_view text)
{
    return {text.begin(), text.end()};
}

/// Has one word, one double word, one array, one text, and counts what it was asked.
struct drive {
    std::uint16_t         word        = 10;
    std::uint32_t         double_word = 0x12345;
    byte_list             text        = characters_of("VLT6000");
    int                   parameters = 0;
    int                   texts      = 0;
    int                   processes  = 0;
    std::uint16_t         control    = 0;
    std::vector<unsigned> commands{};

    process_status operator()(process_command const& given)
    {
        ++processes;
        control = given.control_word();
        return running;
    }
    parameter_answer operator()(parameter_request const& asked)
    {
        ++parameters;
        commands.push_back(static_cast<unsigned>(asked.command()));
        switch (asked.number()) {
        case 202:
        case 206:
        case 415:
            if (auto const written = asked.value<std::uint16_t>()) { word = *written; }
            return parameter_answer::value(word);
        case 291:
            if (auto const written = asked.value<std::uint32_t>()) { double_word = *written; }
            return parameter_answer::value(double_word);
        case 501: return parameter_error::no_bus_access;
        case 615: return parameter_answer::value(static_cast<std::uint8_t>(12 + asked.array_index()));
        default: return parameter_error::parameter_does_not_exist;
        }
    }
    text_answer operator()(text_request const& asked)
    {
        ++texts;
        if (asked.number() == 631) { return parameter_error::no_text; }
        if (asked.access() == text_access::write) { text.assign(asked.characters.begin(), asked.characters.end()); }
        return bytes{text};
    }

    [[nodiscard]] bool was_asked() const { return parameters + texts + processes > 0; }
};

/// What the slave `own` answers; empty if it is silent. Behind the reply nothing may be written.
template <typename Layout = vlt_layout, typename Handler>
byte_list serve_with(address own, bytes wire, Handler&& handler, std::size_t room = 256)
{
    // Of exactly this size on the heap, so that a sanitizer sees what is written behind it.
    auto const buffer = std::make_unique<std::uint8_t[]>(room);
    auto const out    = mutable_bytes{buffer.get(), room};
    for (auto& byte : out) { byte = 0xEE; }
    auto const reply = serve<Layout>(own, wire, out, handler);
    EXPECT_LE(reply.size(), room);
    EXPECT_TRUE(reply.empty() or reply.data() == out.data());
    for (auto i = reply.size(); i < room; ++i) { EXPECT_EQ(out[i], 0xEE) << i << " is behind the reply"; }
    return {reply.begin(), reply.end()};
}

byte_list list_of(bytes from)
{
    return {from.begin(), from.end()};
}

//=== the examples ===//

TEST(slave, replies_as_in_the_examples)
{
    drive vlt;
    EXPECT_EQ(serve_with(one, vectors::read_206, vlt), list_of(vectors::read_206_response));
    EXPECT_EQ(serve_with(one, vectors::write_202, vlt), list_of(vectors::write_202_response));
    EXPECT_EQ(vlt.control, 0x047F);
    EXPECT_EQ(serve_with(one, vectors::write_415, vlt), list_of(vectors::write_415_response));
    EXPECT_EQ(vlt.control, 0x0000);
    EXPECT_EQ(serve_with(one, vectors::read_615_1, vlt), list_of(vectors::read_615_1_response));
    EXPECT_EQ(serve_with(address::short_format(22), vectors::forwards_to_22, vlt), list_of(vectors::status_of_22));
    EXPECT_EQ(serve_with(one, vectors::read_621, vlt), list_of(vectors::read_621_response));
    EXPECT_EQ(serve_with(one, vectors::write_501, vlt), list_of(vectors::write_501_response));
    EXPECT_EQ(serve_with(one, vectors::write_291_1, vlt), list_of(vectors::write_291_1_response));
}

// 533 and 534 are written, although "it is only possible to read parameters with data type 9".
TEST(slave, writes_a_text_and_replies_with_what_it_now_is)
{
    drive      vlt;
    auto const reply = serve_with(one, vectors::write_533, vlt);
    EXPECT_EQ(vlt.text, (byte_list{'H', 'E', 'L', 'L', 'O'}));
    EXPECT_EQ(reply, telegram_of(0x81, "F2 15 05 00 48 45 4C 4C 4F 0F 03 20 00"_hex));
}

//=== a whole exchange by the compiler ===//

struct constant_drive {
    constexpr process_status operator()(process_command const& given) const
    {
        return {given.is_data_valid() ? std::uint16_t{0x0F03} : std::uint16_t{0x0603}, 50_percent};
    }
    constexpr parameter_answer operator()(parameter_request const& asked) const
    {
        if (asked.number() == 206) { return parameter_answer::value(std::int16_t{10}); }
        if (asked.number() == 291) { return parameter_answer::value(-2); }
        return parameter_error::no_write_access;
    }
    constexpr text_answer operator()(text_request const& asked) const
    {
        return asked.number() == 621 ? text_answer{bytes{letters}} : parameter_error::no_text;
    }

    static constexpr auto letters = "56 4C 54"_hex;
};

template <typename Request>
constexpr bool is_answered(address to, Request const& asked, auto const& right)
{
    std::array<std::uint8_t, 256> buffer{};
    auto const                    wire = encode(to, asked);
    auto const                    said = check(to, asked, serve(one, wire, buffer, constant_drive{}));
    return right(said);
}

TEST(slave, answers_its_master_also_while_compiling)
{
    VERIFY(is_answered(one, forwards, [](auto const& said) { return said->status_word() == 0x0F03; }));
    VERIFY(is_answered(one, read_value(206, forwards), [](auto const& said) {
        return *said->template value<std::int16_t>() == 10 and said->process.status_word() == 0x0F03;
    }));
    VERIFY(is_answered(address::long_format(1), read_value(291, data_not_valid), [](auto const& said) {
        return *said->template value<std::int32_t>() == -2 and said->process.status_word() == 0x0603;
    }));
    VERIFY(is_answered(one, write_word(202, 1000, storage::ram, forwards),
                       [](auto const& said) { return said.error().number() == parameter_error::no_write_access; }));
    VERIFY(is_answered(one, read_text(621, forwards),
                       [](auto const& said) { return same_bytes(said->characters, constant_drive::letters); }));
    VERIFY(is_answered(one, write_text(533, "HELLO", forwards),
                       [](auto const& said) { return said.error().number() == parameter_error::no_text; }));
    VERIFY(
        is_answered(one, no_command(forwards), [](auto const& said) { return said->reply() == ak_reply::no_reply; }));
}

//=== whom it answers ===//

TEST(slave, answers_its_own_number_in_every_byte_that_has_it_and_sends_that_back)
{
    for (unsigned own = 0; own < 256; ++own) {
        auto const self = address::from_byte(static_cast<std::uint8_t>(own));
        for (unsigned adr = 0; adr < 256; ++adr) {
            drive      vlt;
            auto const wire  = with_byte(vectors::read_206, 2, adr);
            auto const reply = serve_with(self, wire, vlt);

            auto const is_own =
                not self.is_broadcast() and not self.is_reserved() and not fc_model::is_broadcast(static_cast<int>(adr))
                and fc_model::number_of(static_cast<int>(adr)) == fc_model::number_of(static_cast<int>(own));
            ASSERT_EQ(reply.empty(), not is_own) << adr << " to " << own;
            if (is_own) {
                ASSERT_EQ(reply, with_byte(vectors::read_206_response, 2, adr));
            } else {
                ASSERT_EQ(vlt.was_asked(), fc_model::is_broadcast(static_cast<int>(adr))) << adr << " to " << own;
            }
        }
    }
}

TEST(slave, keeps_the_unused_bit_6_in_its_reply)
{
    drive      vlt;
    auto const reply = serve_with(address::long_format(22), with_byte(vectors::forwards_to_22, 2, 0x56), vlt);
    EXPECT_EQ(reply, with_byte(vectors::status_of_22, 2, 0x56));
}

// "The slave does not send a reply telegram to the master, provided the telegram has been correctly received": as if it
// sent one otherwise.
TEST(slave, carries_out_every_broadcast_and_never_replies_correctly_received_or_not)
{
    for (unsigned adr = 0; adr < 256; ++adr) {
        if (not fc_model::is_broadcast(static_cast<int>(adr))) { continue; }
        for (auto const& [request, parameters, texts] :
             {std::tuple{bytes{vectors::forwards_to_22}, 0, 0}, std::tuple{bytes{vectors::write_202}, 1, 0},
              std::tuple{bytes{vectors::write_533}, 0, 1}}) {
            auto  wire = with_byte(request, 2, adr);
            drive vlt;
            ASSERT_TRUE(serve_with(one, wire, vlt).empty()) << adr;
            ASSERT_EQ(vlt.processes, 1) << adr;
            ASSERT_EQ(vlt.parameters, parameters);
            ASSERT_EQ(vlt.texts, texts);

            wire.back() ^= 0x01;
            drive other;
            ASSERT_TRUE(serve_with(one, wire, other).empty());
            ASSERT_FALSE(other.was_asked());
        }
    }
}

TEST(slave, carries_out_a_broadcast_without_room_for_a_reply)
{
    drive vlt;
    EXPECT_TRUE(serve_with(one, vectors::backwards_to_all_long, vlt, 0).empty());
    EXPECT_TRUE(serve_with(one, with_byte(vectors::write_202, 2, 0x20), vlt, 0).empty());
    EXPECT_EQ(vlt.word, 1000);
    EXPECT_EQ(vlt.processes, 2);
}

//=== what it does not hear ===//

TEST(slave, is_silent_for_every_wrong_bit_and_asks_nobody)
{
    for (auto const whole : vectors::all_fc) {
        auto const own = address::from_byte(whole[2]);
        for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
            byte_list damaged{whole.begin(), whole.end()};
            damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
            drive vlt;
            ASSERT_TRUE(serve_with(own, damaged, vlt).empty()) << bit;
            ASSERT_FALSE(vlt.was_asked()) << bit;
        }
        for (std::size_t size = 0; size < whole.size(); ++size) {
            drive vlt;
            ASSERT_TRUE(serve_with(own, whole.first(size), vlt).empty()) << size;
            ASSERT_FALSE(vlt.was_asked()) << size;
        }
        byte_list longer{whole.begin(), whole.end()};
        longer.push_back(0);
        drive vlt;
        ASSERT_TRUE(serve_with(own, longer, vlt).empty());
        ASSERT_FALSE(vlt.was_asked());
    }
}

TEST(slave, is_silent_for_every_length_that_its_layout_does_not_have)
{
    for (std::size_t size = 0; size <= 252; ++size) {
        for (unsigned const ak : {0x0U, 0x1U, 0xFU}) {
            byte_list data(size, 0x00);
            if (size > 0) { data[0] = static_cast<std::uint8_t>(ak << 4); }
            auto const is_known = size == 4 or size == 12 or (size >= 8 and ak == 0xF);
            drive      vlt;
            EXPECT_EQ(serve_with(one, telegram_of(1, data), vlt).empty(), not is_known) << size << ' ' << ak;
            EXPECT_EQ(vlt.was_asked(), is_known) << size << ' ' << ak;
        }
    }
}

TEST(slave, acts_on_aligned_requests_only)
{
    for (auto const what : {direction::unknown, direction::request, direction::response}) {
        for (bool const aligned : {false, true}) {
            drive                         vlt;
            std::array<std::uint8_t, 256> buffer{};
            frame const                   heard{.raw = vectors::read_206, .direction = what, .aligned = aligned};
            auto const                    is_answered = aligned and what == direction::request;
            EXPECT_EQ(serve(one, heard, buffer, vlt).empty(), not is_answered);
            EXPECT_EQ(vlt.was_asked(), is_answered);
        }
    }
}

//=== commands ===//

TEST(slave, hands_every_command_but_0_to_its_handler_also_those_without_a_meaning)
{
    for (unsigned ak = 0; ak < 16; ++ak) {
        drive      vlt;
        auto const reply = serve_with(one, with_byte(vectors::read_206, 3, ak << 4), vlt);
        ASSERT_FALSE(reply.empty()) << ak;
        ASSERT_EQ(vlt.parameters, ak == 0x0 or ak == 0xF ? 0 : 1) << ak;
        ASSERT_EQ(vlt.texts, ak == 0xF ? 1 : 0) << ak;
        ASSERT_EQ(vlt.processes, 1) << ak;
        if (vlt.parameters == 1) { ASSERT_EQ(vlt.commands, std::vector<unsigned>{ak}); }
    }
}

// AK 0 is "no reply" in this direction: the reply is of no parameter, but there is one.
TEST(slave, replies_to_no_command_with_its_process_data)
{
    drive      vlt;
    auto const asked = telegram_of(1, "00 CA 00 00 12 34 56 78 04 7F 20 00"_hex);
    EXPECT_EQ(serve_with(one, asked, vlt), telegram_of(1, "00 CA 00 00 00 00 00 00 0F 03 20 00"_hex));
    EXPECT_EQ(vlt.control, 0x047F);
}

TEST(slave, may_give_any_reply)
{
    auto const odd = overload{
        [](process_command const&) { return running; },
        [](parameter_request const&) {
            return parameter_answer{ak_reply::description, 0x89ABCDEF};
        },
    };
    EXPECT_EQ(serve_with(one, telegram_of(1, "4A BC 00 64 00 00 00 00 00 00 00 00"_hex), odd),
              telegram_of(1, "3A BC 00 64 89 AB CD EF 0F 03 20 00"_hex));
}

TEST(slave, refuses_with_every_error_number)
{
    for (unsigned number = 0; number <= 0xFFFF; number += 13) {
        auto const refusing = overload{
            [](process_command const&) { return running; },
            [number](parameter_request const&) -> parameter_answer { return static_cast<parameter_error>(number); },
            [number](text_request const&) -> text_answer { return static_cast<parameter_error>(number); },
        };
        for (unsigned const pke : {0x10U, 0xF0U}) {
            auto const reply  = serve_with(one, with_byte(vectors::read_206, 3, pke), refusing);
            auto       wanted = with_byte(vectors::read_206_response, 3, 0x70);
            wanted            = with_byte(wanted, 9, number >> 8);
            wanted            = with_byte(wanted, 10, number & 0xFF);
            ASSERT_EQ(reply, wanted) << number;
        }
    }
}

TEST(slave, without_parameters_has_none)
{
    auto const process_only = [](process_command const&) { return running; };
    EXPECT_EQ(serve_with(one, vectors::read_206, process_only),
              telegram_of(1, "70 CE 00 00 00 00 00 00 0F 03 20 00"_hex));
    EXPECT_EQ(serve_with(one, vectors::read_621, process_only),
              telegram_of(0x81, "72 6D 04 00 00 00 00 00 0F 03 20 00"_hex));
    EXPECT_EQ(serve_with(address::short_format(22), vectors::forwards_to_22, process_only),
              list_of(vectors::status_of_22));
}

TEST(slave, without_texts_has_none)
{
    auto const no_texts = overload{
        [](process_command const&) { return running; },
        [](parameter_request const&) { return parameter_answer::value(std::uint16_t{10}); },
    };
    EXPECT_EQ(serve_with(one, vectors::read_206, no_texts), list_of(vectors::read_206_response));
    EXPECT_EQ(serve_with(one, vectors::read_621, no_texts),
              telegram_of(0x81, "72 6D 04 00 00 00 00 00 0F 03 20 00"_hex));
}

TEST(slave, asks_for_process_data_after_the_parameter)
{
    std::string order;
    auto const  ordered = overload{
        [&order](process_command const&) {
            order += 'p';
            return running;
        },
        [&order](parameter_request const&) {
            order += 'k';
            return parameter_answer::value(std::uint16_t{10});
        },
    };
    EXPECT_FALSE(serve_with(one, vectors::read_206, ordered).empty());
    EXPECT_EQ(order, "kp");
}

//=== values ===//

TEST(parameter_answer, is_as_wide_as_its_type)
{
    VERIFY(parameter_answer::value(std::uint8_t{200}) == parameter_answer{ak_reply::word, 200});
    VERIFY(parameter_answer::value(std::uint16_t{0xFFFF}) == parameter_answer{ak_reply::word, 0xFFFF});
    VERIFY(parameter_answer::value(std::int16_t{-2}) == parameter_answer{ak_reply::word, 0xFFFE});
    VERIFY(parameter_answer::value(std::int8_t{-2}) == parameter_answer{ak_reply::word, 0xFFFE});
    VERIFY(parameter_answer::value(-2) == parameter_answer{ak_reply::double_word, 0xFFFF'FFFE});
    VERIFY(parameter_answer::value(5U) == parameter_answer{ak_reply::double_word, 5});
    VERIFY(parameter_answer{parameter_error::no_bus_access} == parameter_answer{ak_reply::cannot_be_executed, 130});
    VERIFY(parameter_answer{parameter_error::no_text}.reply() == ak_reply::cannot_be_executed);
    VERIFY(parameter_answer{parameter_error::no_text}.pwe() == 15);
}

//=== room ===//

TEST(slave, writes_no_further_than_the_buffer_whatever_its_size)
{
    for (std::size_t const letters : {0U, 1U, 4U, 5U, 100U, 243U, 244U, 245U, 300U}) {
        drive vlt;
        vlt.text.assign(letters, 'x');
        byte_list text_data{0xF2, 0x6D, 0x04, 0x00};
        text_data.resize(4 + letters, 'x');
        text_data.insert(text_data.end(), {0x0F, 0x03, 0x20, 0x00});
        auto const does_not_fit = telegram_of(0x81, "72 6D 04 00 00 00 00 12 0F 03 20 00"_hex);  // 18, other error
        for (std::size_t room = 0; room <= 300; ++room) {
            vlt.processes    = 0;
            auto const reply = serve_with(one, vectors::read_621, vlt, room);
            ASSERT_EQ(vlt.processes, 1);
            if (room < 16) {
                ASSERT_TRUE(reply.empty()) << room;
            } else if (12 + letters <= room and letters <= 244) {
                ASSERT_EQ(reply, telegram_of(0x81, text_data)) << letters << " in " << room;
            } else {
                ASSERT_EQ(reply, does_not_fit) << letters << " in " << room;
            }
        }
    }
}

TEST(slave, carries_out_what_is_asked_without_room_for_the_reply)
{
    for (std::size_t room = 0; room < 16; ++room) {
        drive vlt;
        EXPECT_TRUE(serve_with(one, vectors::write_202, vlt, room).empty());
        EXPECT_EQ(vlt.word, 1000);
        EXPECT_EQ(vlt.control, 0x047F);
        EXPECT_TRUE(serve_with(address::short_format(22), vectors::forwards_to_22, vlt, room).empty());
        EXPECT_EQ(vlt.processes, 2);
    }
    drive vlt;
    EXPECT_EQ(serve_with(one, vectors::write_202, vlt, 16), list_of(vectors::write_202_response));
}

//=== layouts ===//

TEST(slave, serves_other_layouts)
{
    using wide         = data_layout<4, 12>;
    auto const handler = overload{
        [](basic_process_command<wide> const& given) {
            return basic_process_status<wide>{0x0F03, 50_percent, given.pcd(3), given.pcd(2)};
        },
        [](basic_parameter_request<wide> const& asked) { return parameter_answer::value(asked.number()); },
        [](basic_text_request<wide> const& asked) -> text_answer { return asked.characters; },
    };
    constexpr auto command = data_valid<wide>(0x047F, 50_percent, std::uint16_t{1}, std::uint16_t{2});
    EXPECT_EQ(serve_with<wide>(one, encode(one, command), handler), telegram_of(1, "0F 03 20 00 00 02 00 01"_hex));
    EXPECT_EQ(serve_with<wide>(one, encode(one, read_value<wide>(4000, command)), handler),
              telegram_of(1, "1F A0 00 00 00 00 0F A0 0F 03 20 00 00 02 00 01"_hex));
    EXPECT_EQ(serve_with<wide>(one, encode(one, write_text<wide>(4000, "AB", command)), handler),
              telegram_of(1, "FF A0 05 00 41 42 0F 03 20 00 00 02 00 01"_hex));
    EXPECT_TRUE(serve_with<wide>(one, vectors::read_206, handler).empty());
    EXPECT_TRUE(serve_with<wide>(one, encode(one, read_value<wide>(4000, command)), handler, 19).empty());
}

//=== both sides ===//

TEST(slave, answers_random_requests_with_what_its_master_takes)
{
    std::mt19937 random{7};
    drive        vlt;
    for (int round = 0; round < 20'000; ++round) {
        auto const number = *parameter_number::make(random() % 2 == 0 ? 291 : random() % 2048);
        auto const index  = static_cast<std::uint8_t>(random());
        auto const to     = random() % 2 == 0 ? one : address::long_format(1);
        auto const value  = static_cast<std::uint32_t>(random());
        auto const where  = random() % 2 == 0 ? storage::ram : storage::ram_and_eeprom;
        auto const asked  = random() % 2 == 0 ? read_value(number, index, forwards)
                                              : write_double_word(number, index, value, where, forwards);
        auto const said   = check(to, asked, bytes{serve_with(one, encode(to, asked), vlt)});
        if (number.number() == 291) {
            ASSERT_TRUE(said);
            ASSERT_EQ(*said->value<std::uint32_t>(), vlt.double_word);
        } else if (not said) {
            ASSERT_TRUE(said.error().code() == drivecodec::errc::exception_reply
                        or said.error() == reply_error{drivecodec::error(drivecodec::errc::unexpected_reply, 3)})
                << number.number();  // a double word into a word
        }
    }
}

}  // namespace
