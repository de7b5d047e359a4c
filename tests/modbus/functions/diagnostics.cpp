#include <drivecodec/modbus/functions/diagnostics.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = diagnostics::request;
using response = diagnostics::response;

constexpr std::array<std::uint16_t, 1> word_of(std::uint16_t word) { return {word}; }

//=== the specification's examples ===//

TEST(diagnostics, are_what_the_specification_prints)
{
    constexpr auto asked = diagnostics::of(diagnostic::return_query_data, 0xA537);
    VERIFY(encode(asked) == vectors::diagnostics);
    VERIFY(encode(asked.reply()) == vectors::diagnostics);

    constexpr auto decoded = *decode<request>(vectors::diagnostics);
    VERIFY(decoded.sub_function() == diagnostic::return_query_data);
    VERIFY(decoded.data().size() == 1 and decoded.data()[0] == 0xA537);
    VERIFY(decoded.matches(*decode<response>(vectors::diagnostics)).ok());
}

// 6.8.1: the decimal numbers of its table.
TEST(diagnostics, have_the_sub_functions_of_the_specification)
{
    constexpr auto number = [](diagnostic sub) { return static_cast<int>(sub); };
    VERIFY(number(diagnostic::return_query_data) == 0);
    VERIFY(number(diagnostic::restart_communications_option) == 1);
    VERIFY(number(diagnostic::return_diagnostic_register) == 2);
    VERIFY(number(diagnostic::change_ascii_input_delimiter) == 3);
    VERIFY(number(diagnostic::force_listen_only_mode) == 4);
    VERIFY(number(diagnostic::clear_counters_and_diagnostic_register) == 10);
    VERIFY(number(diagnostic::return_bus_message_count) == 11);
    VERIFY(number(diagnostic::return_bus_communication_error_count) == 12);
    VERIFY(number(diagnostic::return_bus_exception_error_count) == 13);
    VERIFY(number(diagnostic::return_server_message_count) == 14);
    VERIFY(number(diagnostic::return_server_no_response_count) == 15);
    VERIFY(number(diagnostic::return_server_nak_count) == 16);
    VERIFY(number(diagnostic::return_server_busy_count) == 17);
    VERIFY(number(diagnostic::return_bus_character_overrun_count) == 18);
    VERIFY(number(diagnostic::clear_overrun_counter_and_flag) == 20);
}

constexpr bool is_named(unsigned sub) { return sub <= 4 or (sub >= 10 and sub <= 18) or sub == 20; }

TEST(diagnostics, keep_every_sub_function_number)
{
    for (unsigned sub = 0; sub <= 0xFFFF; ++sub) {
        std::array<std::uint8_t, 5> const pdu{8, static_cast<std::uint8_t>(sub >> 8), static_cast<std::uint8_t>(sub), 0, 0};
        auto const                        asked = decode<request>(pdu);
        auto const                        given = decode<response>(pdu);
        ASSERT_TRUE(asked and given) << sub;
        ASSERT_EQ(static_cast<unsigned>(asked->sub_function()), sub);
        ASSERT_EQ(static_cast<unsigned>(given->sub_function()), sub);

        std::array<std::uint8_t, 5> out{};
        ASSERT_TRUE(encode(*asked, out));
        ASSERT_EQ(out, pdu);
        out = {};
        ASSERT_TRUE(encode(*given, out));
        ASSERT_EQ(out, pdu);

        ASSERT_EQ(asked->expects_reply(), sub != 4) << sub;
        ASSERT_TRUE(asked->matches(*given).ok()) << sub;
        ASSERT_EQ(diagnostics::has_one_word(static_cast<diagnostic>(sub)), is_named(sub) and sub != 0) << sub;
        ASSERT_EQ(diagnostics::echoes_data(static_cast<diagnostic>(sub)),
                  sub == 0 or sub == 1 or sub == 3 or sub == 10 or sub == 20)
            << sub;
    }
}

//=== what data each may have ===//

TEST(diagnostics, with_a_name_have_one_word_but_query_data)
{
    for (unsigned sub = 1; sub <= 20; ++sub) {
        if (not is_named(sub)) { continue; }
        properties::byte_vector pdu{8, 0, static_cast<std::uint8_t>(sub)};
        EXPECT_EQ(request::check(pdu), (error{errc::truncated, 5})) << sub;
        EXPECT_EQ(request::length(pdu), message_length::exactly(5)) << sub;
        pdu.resize(4);
        EXPECT_EQ(response::check(pdu), (error{errc::truncated, 5})) << sub;
        pdu.resize(7);
        EXPECT_EQ(request::check(pdu), (error{errc::trailing_bytes, 5})) << sub;
        EXPECT_EQ(request::make(static_cast<diagnostic>(sub), {}).error(), (error{errc::bad_value, 3})) << sub;
    }
}

TEST(diagnostics, restart_with_0000_or_FF00)
{
    for (unsigned word = 0; word <= 0xFFFF; ++word) {
        std::array<std::uint8_t, 5> const pdu{8, 0, 1, static_cast<std::uint8_t>(word >> 8), static_cast<std::uint8_t>(word)};
        auto const expected = word == 0 or word == 0xFF00 ? error{} : error{errc::bad_value, 3};
        ASSERT_EQ(request::check(pdu), expected) << word;
        ASSERT_EQ(response::check(pdu), expected) << word;
    }
    VERIFY(diagnostics::clear_log == 0xFF00);
}

TEST(diagnostics, change_the_delimiter_to_any_character)
{
    for (unsigned word = 0; word <= 0xFFFF; ++word) {
        std::array<std::uint8_t, 5> const pdu{8, 0, 3, static_cast<std::uint8_t>(word >> 8), static_cast<std::uint8_t>(word)};
        ASSERT_EQ(request::check(pdu), (word % 256 == 0 ? error{} : error{errc::bad_value, 3})) << word;
    }
}

TEST(diagnostics, ask_for_a_counter_with_0000_and_get_any_value)
{
    for (unsigned const sub : {2U, 11U, 12U, 13U, 14U, 15U, 16U, 17U, 18U}) {
        std::array<std::uint8_t, 5> const pdu{8, 0, static_cast<std::uint8_t>(sub), 0x12, 0x34};
        EXPECT_EQ(request::check(pdu), (error{errc::bad_value, 3})) << sub;
        EXPECT_TRUE(response::check(pdu).ok()) << sub;
    }
}

TEST(diagnostics, clear_with_0000)
{
    VERIFY(request::check("08 00 0A 00 01"_hex) == error{errc::bad_value, 3});
    VERIFY(response::check("08 00 0A 00 01"_hex) == error{errc::bad_value, 3});
    VERIFY(request::check("08 00 14 00 01"_hex) == error{errc::bad_value, 3});
    VERIFY(request::check("08 00 04 00 01"_hex) == error{errc::bad_value, 3});
    VERIFY(request::check("08 00 14 00 00"_hex).ok());
}

TEST(diagnostics, return_any_number_of_words_up_to_125)
{
    std::vector<std::uint16_t> words(126);
    std::mt19937               random{17};
    for (auto& word : words) { word = static_cast<std::uint16_t>(random()); }
    for (std::uint16_t const sub : {std::uint16_t{0}, std::uint16_t{5}, std::uint16_t{19}, std::uint16_t{21}, std::uint16_t{0xFFFF}}) {
        for (std::size_t count = 0; count <= 125; ++count) {
            auto const made = request::make(diagnostic{sub}, register_view{words}.subview(0, count));
            ASSERT_TRUE(made);
            ASSERT_TRUE(properties::round_trips(*made)) << count;
            ASSERT_TRUE(properties::round_trips(made->reply())) << count;
        }
        EXPECT_EQ(request::make(diagnostic{sub}, register_view{words}).error(), (error{errc::bad_value, 3}));
    }
}

TEST(diagnostics, come_in_words)
{
    VERIFY(request::check("08 00 00 01"_hex) == error{errc::bad_length, 3});
    VERIFY(request::check("08 00 00 01 02 03"_hex) == error{errc::bad_length, 5});
    VERIFY(request::check("08 12 34 01"_hex) == error{errc::bad_length, 3});
    VERIFY(request::check("08 00 00"_hex).ok());
    VERIFY(request::length("08 00 00"_hex).is_until_silence());
    VERIFY(request::length("08 00"_hex) == message_length::at_least(3));
}

TEST(diagnostics, are_constants_too)
{
    VERIFY(encode(diagnostics::of(diagnostic::return_bus_message_count)) == "08 00 0B 00 00"_hex);
    VERIFY(encode(diagnostics::of(diagnostic::restart_communications_option, diagnostics::clear_log)) == "08 00 01 FF 00"_hex);
    VERIFY(encode(diagnostics::of(diagnostic::return_query_data, {0x1234, 0x5678})) == "08 00 00 12 34 56 78"_hex);
}

//=== replies ===//

TEST(diagnostics, are_answered_with_the_same_sub_function)
{
    static constexpr auto zero  = word_of(0);
    constexpr auto        asked = *request::make(diagnostic::return_bus_message_count, zero);
    VERIFY(asked.matches(*response::make(diagnostic::return_server_busy_count, zero)) == error{errc::unexpected_reply, 1});
}

TEST(diagnostics, are_answered_with_the_same_data_where_it_is_echoed)
{
    static constexpr auto a   = word_of(0x1234);
    static constexpr auto b   = word_of(0x1235);
    constexpr auto        sub = diagnostic::return_query_data;
    VERIFY(request::make(sub, a)->matches(*response::make(sub, a)).ok());
    VERIFY(request::make(sub, a)->matches(*response::make(sub, b)) == error{errc::unexpected_reply, 3});
    VERIFY(request::make(sub, a)->matches(*response::make(sub, {})) == error{errc::unexpected_reply, 3});
    VERIFY(request::make(sub, {})->matches(*response::make(sub, a)) == error{errc::unexpected_reply, 3});

    static constexpr auto clear = word_of(0xFF00);
    static constexpr auto keep  = word_of(0x0000);
    constexpr auto        start = diagnostic::restart_communications_option;
    VERIFY(request::make(start, clear)->matches(*response::make(start, keep)) == error{errc::unexpected_reply, 3});
}

TEST(diagnostics, reply_with_a_counter)
{
    static constexpr auto zero  = word_of(0);
    static constexpr auto count = word_of(4711);
    constexpr auto        asked = *request::make(diagnostic::return_bus_message_count, zero);
    constexpr auto        given = *asked.reply_with(count);
    VERIFY(asked.matches(given).ok());
    EXPECT_EQ(properties::wire_of(given), properties::copy_of("08 00 0B 12 67"_hex));
    VERIFY(asked.reply_with({}).error() == error{errc::bad_value, 3});
}

TEST(diagnostics, say_that_listen_only_mode_has_no_reply)
{
    VERIFY(not diagnostics::expects_reply("08 00 04 00 00"_hex));
    VERIFY(diagnostics::expects_reply("08 00 03 00 00"_hex));
    VERIFY(diagnostics::expects_reply("08 04 00 00 00"_hex));
    VERIFY(diagnostics::expects_reply("08 00"_hex));
}

}  // namespace
