#include <drivecodec/modbus/server.hpp>

#include "support/exchanges.hpp"
#include "support/full_device.hpp"
#include "support/verify.hpp"

#include <drivecodec/core/overload.hpp>
#include <drivecodec/modbus/client.hpp>

#include <memory>
#include <vector>

namespace {

using namespace drivecodec::modbus;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using drivecodec::mutable_bytes;
using drivecodec::overload;
using byte_list = std::vector<std::uint8_t>;
using full_device::device;
using full_device::my_function;

template <typename Functions = void, typename Handler>
byte_list serve(bytes pdu, Handler&& handler)
{
    byte_list  out(max_pdu_size, 0xEE);
    auto const size = serve_pdu<Functions>(pdu, out, handler);
    EXPECT_LE(size, out.size());
    for (auto i = size; i < out.size(); ++i) { EXPECT_EQ(out[i], 0xEE) << "behind the reply"; }
    out.resize(size);
    return out;
}

byte_list list_of(bytes from) { return {from.begin(), from.end()}; }

byte_list refusal(unsigned function, unsigned code)
{
    return {static_cast<std::uint8_t>(function | 0x80U), static_cast<std::uint8_t>(code)};
}

//=== the reply to every request ===//

TEST(server, replies_to_every_request_what_its_client_takes)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        device     served;
        auto const reply = serve(given.request, served);
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        auto const taken = check_reply(asked, reply);
        EXPECT_TRUE(taken) << function::name;
        EXPECT_GE(served.asked, 1U) << function::name;
    });
}

TEST(server, passes_on_every_exception_of_the_handler)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        for (unsigned code = 1; code < 256; ++code) {
            device served;
            served.broken = static_cast<exception_code>(code);
            ASSERT_EQ(serve(given.request, served), refusal(to_byte(function::code), code)) << function::name;
        }
    });
}

TEST(server, repeats_what_was_written)
{
    for (bytes pdu : {bytes{vectors::write_single_coil}, bytes{vectors::write_single_register},
                      bytes{vectors::mask_write_register}, bytes{vectors::write_file_record}}) {
        device served;
        EXPECT_EQ(serve(pdu, served), list_of(pdu));
    }
    device served;
    EXPECT_EQ(serve(vectors::write_multiple_registers_request, served), list_of(vectors::write_multiple_registers_response));
    EXPECT_EQ(served.words[1], 0x000A);
    EXPECT_EQ(served.words[2], 0x0102);
    EXPECT_EQ(serve(vectors::write_multiple_coils_request, served), list_of(vectors::write_multiple_coils_response));
    EXPECT_TRUE(served.bits[19] and not served.bits[20] and served.bits[21]);
    EXPECT_TRUE(served.bits[27] and not served.bits[28]);
}

TEST(server, writes_before_it_reads)
{
    device served;
    EXPECT_EQ(serve("17 00 0E 00 03 00 0E 00 02 04 12 34 56 78"_hex, served), list_of("17 06 12 34 56 78 00 00"_hex));
}

TEST(server, writes_unused_bits_as_zeros)
{
    device served;
    served.bits.fill(true);
    EXPECT_EQ(serve("01 00 00 00 0B"_hex, served), list_of("01 02 FF 07"_hex));
}

constexpr auto reads_two      = "03 00 6B 00 02"_hex;
constexpr auto reply_with_two = "03 04 02 2B 00 64"_hex;

struct two_words {
    std::array<std::uint16_t, 2> words{0x022B, 0x0064};

    constexpr register_view operator()(read_holding_registers::request const&) const { return words; }
};

constexpr bool replies_with_two()
{
    std::array<std::uint8_t, max_pdu_size> out{};
    two_words const                        handler{};
    auto const                             size = serve_pdu(reads_two, out, handler);
    return drivecodec::same_bytes(bytes{out}.first(size), reply_with_two);
}

TEST(server, serves_in_constant_expressions)
{
    VERIFY(replies_with_two());
}

//=== what handlers are ===//

TEST(server, takes_lambdas_as_one_handler)
{
    std::array<std::uint16_t, 4> words{1, 2, 3, 4};
    auto const handler = overload{
        [&words](read_holding_registers::request const& r) {
            return register_view{std::span<std::uint16_t const>{words}.first(r.range.count())};
        },
        [&words](write_single_register::request const& r) -> answer<done> {
            if (r.address >= words.size()) { return exception_code::illegal_data_address; }
            words[r.address] = r.value;
            return done{};
        },
    };
    EXPECT_EQ(serve("03 00 00 00 02"_hex, handler), list_of("03 04 00 01 00 02"_hex));
    EXPECT_EQ(serve("06 00 01 12 34"_hex, handler), list_of("06 00 01 12 34"_hex));
    EXPECT_EQ(words[1], 0x1234);
    EXPECT_EQ(serve("06 00 04 12 34"_hex, handler), refusal(6, 2));
    EXPECT_EQ(serve("10 00 00 00 01 02 00 00"_hex, handler), refusal(0x10, 1));
}

TEST(server, takes_handlers_that_are_const_mutable_or_temporary)
{
    struct constant {
        std::uint8_t operator()(read_exception_status::request const&) const { return 7; }
    };
    struct counter {
        std::uint8_t count = 0;
        std::uint8_t operator()(read_exception_status::request const&) { return ++count; }
    };
    constant const unchanging{};
    counter        counting;
    EXPECT_EQ(serve("07"_hex, unchanging), list_of("07 07"_hex));
    EXPECT_EQ(serve("07"_hex, counting), list_of("07 01"_hex));
    EXPECT_EQ(serve("07"_hex, counting), list_of("07 02"_hex));
    EXPECT_EQ(counting.count, 2);
    EXPECT_EQ(serve("07"_hex, counter{.count = 8}), list_of("07 09"_hex));
    EXPECT_EQ(serve("07"_hex, [count = std::uint8_t{4}](read_exception_status::request const&) mutable { return ++count; }),
              list_of("07 05"_hex));
}

TEST(server, takes_a_response_or_what_makes_one)
{
    std::array<std::uint16_t, 1> const one{0x0102};
    EXPECT_EQ(serve("03 00 00 00 01"_hex, [&](read_holding_registers::request const&) {
        return *read_holding_registers::response::make(one);
    }), list_of("03 02 01 02"_hex));
    EXPECT_EQ(serve("03 00 00 00 01"_hex, [](read_holding_registers::request const&) {
        static constexpr auto wire = "01 02"_hex;
        return register_view::of_wire(wire);
    }), list_of("03 02 01 02"_hex));
    EXPECT_EQ(serve("03 00 00 00 01"_hex, [](read_holding_registers::request const&) {
        return exception_code::server_device_busy;
    }), refusal(3, 6));
    EXPECT_EQ(serve("06 00 01 12 34"_hex, [](write_single_register::request const& r) { return r.reply(); }),
              list_of("06 00 01 12 34"_hex));
}

//=== exception 01 ===//

TEST(server, refuses_every_function_that_the_handler_lacks)
{
    auto const handler = overload{
        [](read_exception_status::request const&) { return std::uint8_t{1}; },
        [](write_single_register::request const&) { return done{}; },
    };
    for (unsigned function = 0; function < 256; ++function) {
        for (auto const size : {1U, 2U, 5U, 253U}) {
            byte_list pdu(size, 0);
            pdu[0]           = static_cast<std::uint8_t>(function);
            auto const reply = serve(pdu, handler);
            if (function >= 0x80) {
                EXPECT_TRUE(reply.empty()) << function;
            } else if (function == 6) {
                EXPECT_EQ(reply, size == 5 ? pdu : refusal(6, 3));
            } else if (function == 7) {
                EXPECT_EQ(reply, size == 1 ? list_of("07 01"_hex) : refusal(7, 3));
            } else {
                EXPECT_EQ(reply, refusal(function, 1)) << function;
            }
        }
    }
}

TEST(server, refuses_mei_types_that_the_handler_lacks)
{
    auto const handler = [](read_device_identification::request const& r) {
        return read_device_identification::answer(r, device_conformity::basic_and_specific, full_device::identity);
    };
    for (unsigned mei = 0; mei < 256; ++mei) {
        if (mei == 0x0E) { continue; }
        byte_list const pdu{0x2B, static_cast<std::uint8_t>(mei), 1, 0};
        EXPECT_EQ(serve(pdu, handler), refusal(0x2B, 1)) << mei;
    }
    EXPECT_EQ(serve("2B"_hex, handler).size(), 2U);
    EXPECT_EQ(serve("2B 0E 05 00"_hex, handler), refusal(0x2B, 3));
    EXPECT_EQ(serve("2B 0E 04 09"_hex, handler), refusal(0x2B, 2));
    EXPECT_EQ(serve("2B 0E 01"_hex, handler), refusal(0x2B, 3));
}

TEST(server, replies_nothing_to_nothing)
{
    device served;
    EXPECT_TRUE(serve({}, served).empty());
    EXPECT_EQ(served.asked, 0U);
}

//=== exceptions 02 and 03 ===//

template <std::size_t N>
void is_refused(std::array<std::uint8_t, N> const& pdu, unsigned code)
{
    device served;
    EXPECT_EQ(serve(pdu, served), refusal(pdu[0], code)) << int{pdu[0]};
    EXPECT_EQ(served.asked, 0U) << int{pdu[0]};
}

TEST(server, refuses_a_range_past_the_last_address_with_02)
{
    is_refused("01 FF FF 00 02"_hex, 2);
    is_refused("02 FF 00 01 01"_hex, 2);
    is_refused("03 FF FF 00 02"_hex, 2);
    is_refused("04 FF 84 00 7D"_hex, 2);
    is_refused("0F FF FF 00 02 01 03"_hex, 2);
    is_refused("10 FF FF 00 02 04 00 00 00 00"_hex, 2);
    is_refused("17 FF FF 00 02 00 00 00 01 02 00 00"_hex, 2);
    is_refused("17 00 00 00 02 FF FF 00 02 04 00 00 00 00"_hex, 2);
    is_refused("14 07 06 00 00 00 00 00 01"_hex, 2);      // file 0
    is_refused("14 07 06 00 01 27 10 00 01"_hex, 2);      // record 10000
    is_refused("15 09 06 00 00 00 00 00 01 00 00"_hex, 2);
}

TEST(server, refuses_a_wrong_quantity_with_03)
{
    is_refused("01 00 00 00 00"_hex, 3);
    is_refused("01 00 00 07 D1"_hex, 3);
    is_refused("02 00 00 FF FF"_hex, 3);
    is_refused("03 00 00 00 00"_hex, 3);
    is_refused("03 00 00 00 7E"_hex, 3);
    is_refused("04 00 00 80 01"_hex, 3);
    is_refused("03 FF FF 00 7E"_hex, 3);  // the quantity comes before the range
    is_refused("0F 00 00 00 00 00"_hex, 3);
    is_refused("10 00 00 00 00 00"_hex, 3);
    is_refused("10 00 00 80 01 02 00 00"_hex, 3);  // doubled it would be 2
    is_refused("17 00 00 00 00 00 00 00 01 02 00 00"_hex, 3);
    is_refused("17 00 00 00 01 00 00 00 00 00"_hex, 3);
    is_refused("17 00 00 00 7E 00 00 00 01 02 00 00"_hex, 3);
}

TEST(server, refuses_a_wrong_byte_count_value_or_length_with_03)
{
    is_refused("05 00 00 12 34"_hex, 3);
    is_refused("05 00 00 FF 01"_hex, 3);
    is_refused("0F 00 00 00 08 00"_hex, 3);
    is_refused("0F 00 00 00 08 02 00 00"_hex, 3);
    is_refused("10 00 00 00 01 00"_hex, 3);
    is_refused("10 00 00 00 01 03 00 00 00"_hex, 3);
    is_refused("10 00 00 00 01 FF 00 00"_hex, 3);
    is_refused("10 00 00 00 02 04 00 00"_hex, 3);
    is_refused("03 00 00 00 01 00"_hex, 3);
    is_refused("03 00 00 00"_hex, 3);
    is_refused("16 00 00 00 00 00"_hex, 3);
    is_refused("17 00 03 00 06 00 0E 00 03 06"_hex, 3);
    is_refused("18 00"_hex, 3);
    is_refused("07 00"_hex, 3);
    is_refused("08 00 0A 00 01"_hex, 3);
    is_refused("08 00 00 00"_hex, 3);
    is_refused("14 00"_hex, 3);
    is_refused("14 06 06 00 01 00 00 00"_hex, 3);
    is_refused("14 07 05 00 01 00 00 00 01"_hex, 3);
    is_refused("15 09 06 00 01 00 00 80 01 00 00"_hex, 3);  // doubled it would be 2
}

TEST(server, refuses_every_truncated_request_with_03)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        for (std::size_t size = 1; size < given.request.size(); ++size) {
            auto const prefix = list_of(given.request.first(size));
            if (function::request::check(prefix).ok()) { continue; }  // of no fixed length
            device     served;
            auto const reply = serve(prefix, served);
            auto const mei   = to_byte(function::code) == 0x2B and size < 2;
            ASSERT_EQ(reply, refusal(to_byte(function::code), mei ? 1 : 3)) << function::name << size;
            ASSERT_EQ(served.asked, 0U);
        }
    });
}

TEST(server, refuses_requests_of_files_that_no_response_can_carry)
{
    byte_list pdu{0x14, 35 * 7};
    for (int i = 0; i < 35; ++i) { pdu.insert(pdu.end(), {6, 0, 1, 0, 0, 0, 4}); }
    device served;
    EXPECT_EQ(serve(pdu, served), refusal(0x14, 3));
    EXPECT_EQ(served.asked, 0U);
    for (std::size_t i = 8; i < pdu.size(); i += 7) { pdu[i] = 2; }  // 35 x (2 + 4) = 210
    EXPECT_EQ(serve(pdu, served).size(), 212U);
}

TEST(server, refuses_one_byte_pdus_of_every_function_that_has_fields)
{
    for (unsigned function = 0; function < 0x80; ++function) {
        device          served;
        byte_list const pdu{static_cast<std::uint8_t>(function)};
        auto const      reply = serve(pdu, served);
        ASSERT_GE(reply.size(), 2U) << function;
        auto const has_no_fields = function == 7 or function == 11 or function == 12 or function == 17;
        EXPECT_EQ((reply[0] & 0x80) == 0, has_no_fields) << function;
    }
}

//=== exception 04 ===//

template <typename Request, std::size_t N>
void fails(std::array<std::uint8_t, N> const& pdu, auto answer_with)
{
    EXPECT_EQ(serve(pdu, [&](Request const&) { return answer_with; }), refusal(pdu[0], 4)) << int{pdu[0]};
}

std::array<std::uint16_t, 40'000> const many_words{};
std::array<bool, 40'000> const          many_bits{};

register_view words(std::size_t count) { return std::span<std::uint16_t const>{many_words}.first(count); }
coil_view     bits(std::size_t count) { return std::span<bool const>{many_bits}.first(count); }

constexpr auto two_bytes_of_ones = "FF FF"_hex;

TEST(server, fails_if_the_handler_gives_more_or_less_than_was_asked_for)
{
    for (auto const count : {0U, 1U, 3U, 4U, 125U, 126U, 127U, 128U, 130U, 1000U, 32'769U, 32'770U}) {
        fails<read_holding_registers::request>("03 00 00 00 02"_hex, words(count));
        fails<read_input_registers::request>("04 00 00 00 02"_hex, words(count));
        fails<read_write_multiple_registers::request>("17 00 00 00 02 00 00 00 01 02 00 00"_hex, words(count));
    }
    for (auto const count : {0U, 1U, 8U, 17U, 2000U, 2001U, 2056U, 2064U, 32'769U}) {
        fails<read_coils::request>("01 00 00 00 10"_hex, bits(count));
        fails<read_discrete_inputs::request>("02 00 00 00 10"_hex, bits(count));
    }
}

TEST(server, clears_the_bits_behind_the_last_coil_asked_for)
{
    auto const all_set = [](auto const&) { return coil_view::of_wire(bytes{two_bytes_of_ones}); };
    EXPECT_EQ(serve("01 00 00 00 0B"_hex, [&](read_coils::request const& asked) { return all_set(asked); }),
              list_of("01 02 FF 07"_hex));
    EXPECT_EQ(serve("02 00 00 00 10"_hex, [&](read_discrete_inputs::request const& asked) { return all_set(asked); }),
              list_of("02 02 FF FF"_hex));
    fails<read_coils::request>("01 00 00 00 11"_hex, coil_view::of_wire(bytes{two_bytes_of_ones}));
}

TEST(server, clears_them_in_whatever_the_handler_gives)
{
    static constexpr std::array<bool, 16> set = [] {
        std::array<bool, 16> states{};
        for (auto& state : states) { state = true; }
        return states;
    }();
    auto const expected = list_of("01 02 FF 03"_hex);
    static constexpr auto asked = "01 00 00 00 0A"_hex;
    auto const            ask   = [](auto const& given) {
        return serve(asked, [&](read_coils::request const&) { return given; });
    };
    EXPECT_EQ(ask(set), expected);
    EXPECT_EQ(ask(std::span<bool const>{set}), expected);
    EXPECT_EQ(ask(coil_view{set}), expected);
    EXPECT_EQ(ask(coil_array<16>{set}), expected);
    EXPECT_EQ(ask(*read_coils::response::make(set)), expected);
}

TEST(server, fails_if_the_handler_gives_another_response)
{
    std::array<std::uint16_t, 3> const three{};
    fails<read_holding_registers::request>("03 00 00 00 02"_hex, *read_holding_registers::response::make(three));
    fails<write_single_register::request>("06 00 00 00 02"_hex, write_single_register::request{1, 2}.reply());
    fails<diagnostics::request>("08 00 0B 00 00"_hex, *diagnostics::response::make(diagnostic::return_server_nak_count,
                                                                                  register_view{three}.subview(0, 1)));
}

TEST(server, makes_responses_of_what_the_handler_gives)
{
    EXPECT_EQ(serve("11"_hex, [](report_server_id::request const&) { return bytes{vectors::exception_response}; }),
              list_of("11 02 81 02"_hex));
    EXPECT_EQ(serve("18 00 00"_hex, [](read_fifo_queue::request const&) { return words(1); }),
              list_of("18 00 04 00 01 00 00"_hex));
    static std::array const one{*file_values::make(words(1))};
    EXPECT_EQ(serve("14 07 06 00 01 00 00 00 01"_hex, [](read_file_record::request const&) {
        return record_list<file_values>{one};
    }), list_of("14 04 03 06 00 00"_hex));
}

TEST(server, fails_if_the_handler_gives_more_than_a_pdu_carries)
{
    std::array<std::uint8_t, 300> const bytes_300{};
    fails<report_server_id::request>("11"_hex, bytes{bytes_300});
    fails<report_server_id::request>("11"_hex, bytes{bytes_300}.first(252));
    fails<report_server_id::request>("11"_hex, bytes{});
    EXPECT_EQ(serve("11"_hex, [&](report_server_id::request const&) { return bytes{bytes_300}.first(251); }).size(), 253U);

    for (auto const count : {32U, 125U, 126U, 32'769U}) { fails<read_fifo_queue::request>("18 00 00"_hex, words(count)); }

    auto const one  = *file_values::make(words(124));
    auto const list = std::array{one, one};
    fails<read_file_record::request>("14 07 06 00 01 00 00 00 7C"_hex, record_list<file_values>{list});
}

TEST(server, never_writes_behind_the_room_it_has)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        device     all;
        auto const whole = serve(given.request, all);
        for (std::size_t size = 0; size <= 256; ++size) {
            device     served;
            auto const out     = std::make_unique<std::uint8_t[]>(size);  // of just this size
            auto const written = serve_pdu(given.request, mutable_bytes{out.get(), size}, served);
            ASSERT_LE(written, size) << function::name;
            auto const reply = byte_list(out.get(), out.get() + written);
            if (size >= whole.size()) {
                ASSERT_EQ(reply, whole) << function::name << size;
            } else if (size >= 2) {
                ASSERT_EQ(reply, refusal(to_byte(function::code), 4)) << function::name << size;
            } else {
                ASSERT_TRUE(reply.empty()) << function::name << size;
            }
        }
    });
}

//=== nobody to answer ===//

TEST(server, is_silent_after_force_listen_only_mode)
{
    device served;
    EXPECT_TRUE(serve("08 00 04 00 00"_hex, served).empty());
    EXPECT_EQ(served.asked, 1U);
}

TEST(server, runs_only_writes_where_there_is_nobody_to_answer)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        device served;
        EXPECT_EQ(serve_pdu(given.request, {}, served), 0U) << function::name;
        EXPECT_EQ(served.asked, is_write<function>() ? 1U : 0U) << function::name;
    });
}

//=== a function of one's own ===//

struct my_device {
    using functions = public_functions::with<my_function>;

    std::size_t  surplus = 0;
    device       rest{};
    byte_list    memory = byte_list(300, 0x55);

    my_function::response operator()(my_function::request const& r) { return {bytes{memory}.first(r.count + surplus)}; }
    template <typename Request>
        requires std::is_invocable_v<device&, Request const&>
    auto operator()(Request const& r)
    {
        return rest(r);
    }
};

TEST(server, serves_a_function_of_ones_own)
{
    my_device served;
    auto const reply = serve("41 03"_hex, served);
    EXPECT_EQ(reply, list_of("41 03 55 55 55"_hex));
    EXPECT_TRUE(check_reply(my_function::request{3}, reply));
    EXPECT_FALSE(check_reply(my_function::request{4}, reply));
    EXPECT_EQ(serve("03 00 00 00 01"_hex, served), list_of("03 02 00 00"_hex));
    EXPECT_EQ(serve("41"_hex, served), refusal(0x41, 3));
    EXPECT_EQ(serve("41 03 00"_hex, served), refusal(0x41, 3));
    EXPECT_EQ(serve("42 03"_hex, served), refusal(0x42, 1));
    served.surplus = 1;
    EXPECT_EQ(serve("41 03"_hex, served), refusal(0x41, 4));
    served.surplus = 0;
    EXPECT_EQ(serve("41 FF"_hex, served), refusal(0x41, 4));  // 257 bytes
}

TEST(server, serves_the_functions_that_it_is_told_to_serve)
{
    auto const handler = [](my_function::request const& r) { return my_function::response{bytes{vectors::diagnostics}.first(r.count)}; };
    EXPECT_EQ(serve<function_set<my_function>>("41 02"_hex, handler), list_of("41 02 08 00"_hex));
    EXPECT_EQ(serve("41 02"_hex, handler), refusal(0x41, 1));  // a public function it is not
}

}  // namespace
