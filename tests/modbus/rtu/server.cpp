#include <drivecodec/modbus/rtu/server.hpp>

#include "support/exchanges.hpp"
#include "support/full_device.hpp"
#include "support/rtu_model.hpp"
#include "support/verify.hpp"

#include <drivecodec/core/overload.hpp>
#include <drivecodec/modbus/rtu/client.hpp>
#include <drivecodec/modbus/rtu/reader.hpp>

#include <memory>

namespace {

namespace modbus = drivecodec::modbus;
namespace rtu    = drivecodec::modbus::rtu;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::mutable_bytes;
using drivecodec::overload;
using full_device::device;
using full_device::my_function;
using modbus::read_holding_registers;
using modbus::write_single_register;
using rtu_model::adu_of;
using rtu_model::byte_list;

/// What the server 17 answers; empty if it is silent.
template <typename Handler>
byte_list serve(byte_list const& adu, Handler&& handler)
{
    byte_list  buffer(256, 0xEE);
    auto const reply = rtu::serve(17, bytes{adu}, buffer, handler);
    EXPECT_TRUE(reply.empty() or reply.data() == buffer.data());
    for (auto i = reply.size(); i < buffer.size(); ++i) { EXPECT_EQ(buffer[i], 0xEE) << "behind the reply"; }
    return {reply.begin(), reply.end()};
}

byte_list refusal(unsigned function, unsigned code)
{
    return adu_of(17, byte_list{static_cast<std::uint8_t>(function | 0x80U), static_cast<std::uint8_t>(code)});
}

TEST(rtu_server, replies_to_every_request_what_its_client_takes)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        device     served;
        auto const reply = serve(adu_of(17, given.request), served);
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        EXPECT_TRUE(rtu::check(17, asked, bytes{reply})) << function::name;
    });
}

TEST(rtu_server, replies_with_its_address_and_a_crc)
{
    device served;
    served.words[0] = 0x1234;
    EXPECT_EQ(serve(adu_of(17, "03 00 00 00 01"_hex), served), adu_of(17, "03 02 12 34"_hex));
    EXPECT_EQ(serve(adu_of(17, "03 FF FF 00 02"_hex), served), refusal(3, 2));
    EXPECT_EQ(serve(adu_of(17, "42 01 02"_hex), served), refusal(0x42, 1));
}

//=== silence ===//

TEST(rtu_server, is_silent_for_every_other_server)
{
    for (int address = 0; address < 256; ++address) {
        device     served;
        auto const reply = serve(adu_of(address, "03 00 00 00 01"_hex), served);
        EXPECT_EQ(reply.empty(), address != 17) << address;
        EXPECT_EQ(served.asked, address == 17 ? 1U : 0U) << address;
    }
}

TEST(rtu_server, is_silent_for_every_damaged_frame)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        device     served;
        auto const whole = adu_of(17, given.request);
        for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
            auto damaged = whole;
            damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
            ASSERT_TRUE(serve(damaged, served).empty()) << function::name << bit;
        }
        for (std::size_t size = 0; size < whole.size(); ++size) {
            ASSERT_TRUE(serve(byte_list(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)), served).empty());
        }
        ASSERT_EQ(served.asked, 0U);
    });
}

TEST(rtu_server, is_silent_for_frames_of_more_than_256_bytes)
{
    device     served;
    byte_list  pdu(254, 0);
    pdu[0]          = 0x42;
    EXPECT_TRUE(serve(adu_of(17, pdu), served).empty());
    pdu.pop_back();
    EXPECT_EQ(serve(adu_of(17, pdu), served), refusal(0x42, 1));
}

TEST(rtu_server, carries_out_the_writes_of_a_broadcast_and_says_nothing)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        device served;
        EXPECT_TRUE(serve(adu_of(0, given.request), served).empty()) << function::name;
        EXPECT_EQ(served.asked, modbus::is_write<function>() ? 1U : 0U) << function::name;
    });
    device served;
    EXPECT_TRUE(serve(adu_of(0, "06 00 05 12 34"_hex), served).empty());
    EXPECT_EQ(served.words[5], 0x1234);
    EXPECT_TRUE(serve(adu_of(0, "06 12 34 00 00"_hex), served).empty());  // no such register
    EXPECT_TRUE(serve(adu_of(0, "05 00 00 12 34"_hex), served).empty());  // no such value
    EXPECT_TRUE(serve(adu_of(0, "42"_hex), served).empty());              // no such function
}

TEST(rtu_server, needs_no_room_for_a_broadcast)
{
    for (std::size_t room = 0; room <= 4; ++room) {
        device     served;
        byte_list  buffer(room, 0xEE);
        auto const reply = rtu::serve(17, bytes{adu_of(0, "06 00 01 12 34"_hex)}, buffer, served);
        EXPECT_TRUE(reply.empty());
        EXPECT_EQ(served.words[1], 0x1234);
        EXPECT_EQ(buffer, byte_list(room, 0xEE));
    }
}

TEST(rtu_server, is_silent_after_force_listen_only_mode)
{
    device served;
    EXPECT_TRUE(serve(adu_of(17, "08 00 04 00 00"_hex), served).empty());
    EXPECT_EQ(served.asked, 1U);
    EXPECT_FALSE(serve(adu_of(17, "08 00 01 00 00"_hex), served).empty());
}

TEST(rtu_server, answers_only_functions_without_the_exception_bit)
{
    auto const handler = [](modbus::read_exception_status::request const&) { return std::uint8_t{1}; };
    for (unsigned function = 0; function < 256; ++function) {
        auto const reply = serve(adu_of(17, byte_list{static_cast<std::uint8_t>(function)}), handler);
        if (function == 7) {
            EXPECT_EQ(reply, adu_of(17, "07 01"_hex));
        } else {
            EXPECT_EQ(reply, function < 0x80 ? refusal(function, 1) : byte_list{}) << function;
        }
    }
}

//=== frames of a reader ===//

TEST(rtu_server, acts_on_aligned_requests_only)
{
    auto const adu = adu_of(17, "06 00 05 12 34"_hex);
    byte_list  buffer(256);
    for (bool aligned : {false, true}) {
        for (auto direction : {modbus::direction::request, modbus::direction::response}) {
            device     served;
            auto const acts  = aligned and direction == modbus::direction::request;
            auto const reply = rtu::serve(17, rtu::frame{.raw = adu, .direction = direction, .aligned = aligned}, buffer, served);
            EXPECT_EQ(reply.size(), acts ? 8U : 0U);
            EXPECT_EQ(served.asked, acts ? 1U : 0U);
        }
    }
}

TEST(rtu_server, hears_and_answers_on_a_shared_line)
{
    // Another server's traffic, the same function asked twice, its own answers heard back: all come by.
    rtu::reader reader{rtu::expecting::either, 17};
    device      served;
    byte_list   buffer(256);
    unsigned    answered = 0;
    auto const  hear     = [&](byte_list const& heard) {
        ASSERT_TRUE(reader.push(heard).empty());
        while (auto const given = reader.next()) {
            ASSERT_NE(given.frame(), nullptr);
            answered += rtu::serve(17, *given.frame(), buffer, served).empty() ? 0U : 1U;
        }
    };
    hear(adu_of(5, "03 00 00 00 01"_hex));
    hear(adu_of(5, "03 02 11 06"_hex));
    hear(adu_of(17, "06 00 00 00 07"_hex));
    hear(adu_of(17, "06 00 00 00 07"_hex));
    hear(adu_of(5, "06 00 00 00 07"_hex));
    hear(adu_of(5, "06 00 00 00 07"_hex));
    EXPECT_EQ(answered, 2U);
    EXPECT_EQ(served.asked, 2U);
}

//=== room ===//

TEST(rtu_server, never_writes_behind_the_room_it_has)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        device     all;
        auto const request = adu_of(17, given.request);
        auto const whole   = serve(request, all);
        for (std::size_t size = 0; size <= 256; ++size) {
            device     served;
            auto const out   = std::make_unique<std::uint8_t[]>(size);  // of just this size
            auto const given_reply = rtu::serve(17, bytes{request}, mutable_bytes{out.get(), size}, served);
            auto const reply       = byte_list(given_reply.begin(), given_reply.end());
            if (size >= whole.size()) {
                ASSERT_EQ(reply, whole) << function::name << size;
            } else if (size >= 5) {
                ASSERT_EQ(reply, refusal(to_byte(function::code), 4)) << function::name << size;
            } else {
                ASSERT_TRUE(reply.empty()) << function::name << size;
            }
        }
    });
}

TEST(rtu_server, fails_if_the_handler_gives_too_much)
{
    static constexpr std::array<std::uint16_t, 126> words{};
    auto const asks_for_126 = adu_of(17, "03 00 00 00 7E"_hex);
    auto const asks_for_125 = adu_of(17, "03 00 00 00 7D"_hex);
    auto const handler      = [](read_holding_registers::request const&) { return modbus::register_view{words}; };
    EXPECT_EQ(serve(asks_for_126, handler), refusal(3, 3));
    EXPECT_EQ(serve(asks_for_125, handler), refusal(3, 4));
    auto const right = [](read_holding_registers::request const& r) {
        return modbus::register_view{words}.subview(0, r.range.count());
    };
    EXPECT_EQ(serve(asks_for_125, right).size(), 255U);
}

//=== inputs that broke others ===//

TEST(rtu_server, survives_inputs_that_broke_others)
{
    struct input {
        byte_list pdu;
        byte_list reply;
    };
    auto const refused = [](byte_list pdu, unsigned code) { return input{pdu, refusal(pdu[0], code)}; };
    auto const padded  = [](byte_list pdu, std::size_t size) {
        pdu.resize(size, 0);
        return pdu;
    };
    std::vector<input> inputs{
        refused({0x10, 0, 0, 0, 0x7B, 0xF6}, 3),                             // byte count, no values
        refused({0x10, 0, 0, 0, 1, 0}, 3),                                   // byte count 0
        refused({0x10, 0, 0, 0, 1, 3, 1, 2, 3}, 3),                          // odd
        refused(padded({0x10, 0, 0, 0, 0x7F, 255}, 253), 3),                 // 255, of 127 registers
        refused({0x10, 0, 0, 0x80, 1, 2, 0, 0}, 3),                          // doubled, it is 2
        refused({0x0F, 0, 0, 0x07, 0xB1, 0xF7}, 3),                          // 1969 coils
        refused({0x0F, 0, 0, 0xFF, 0xFF, 0}, 3),                             // rounded up to bytes, it is 0
        refused({0x14, 14, 6, 0, 1, 0, 0, 0, 124, 6, 0, 1, 0, 0, 0, 124}, 3),  // together more than a response
        refused({0x14, 7, 6, 0, 1, 0, 0, 0x80, 0}, 3),
        refused({0x15, 9, 6, 0, 1, 0, 0, 0xFF, 0xFF, 0, 0}, 3),
        refused({0x15, 16, 6, 0, 1, 0, 0, 0, 1, 0, 0, 6, 0, 1, 0, 0, 0, 9}, 3),  // the second is cut off
        refused({0x17, 0, 0, 0, 1, 0, 0, 0, 1, 2}, 3),                       // ends behind its byte count
        refused({0x17, 0, 0, 0, 1, 0, 0, 0, 1}, 3),                          // and before it
        refused({0x17, 0, 0, 0, 1, 0, 0, 0, 0x7A, 0xF4}, 3),                 // 122 registers
        refused({0x05, 0, 0, 0x12, 0x34}, 3),
        refused({0x2B, 0x0E, 0, 0}, 3),
        refused({0x2B, 0x0E, 4, 0x7F}, 2),
        refused({0x2B, 0x0F, 0, 0}, 1),
        refused({0x2B}, 1),
        refused({0x18, 0, 0, 0}, 3),
        refused(byte_list(253, 0x42), 1),
        refused(byte_list(253, 0x03), 3),
        refused(byte_list(253, 0x00), 1),
        input{byte_list(253, 0xFF), {}},
    };
    for (auto const& [pdu, reply] : inputs) {
        device served;
        EXPECT_EQ(serve(adu_of(17, pdu), served), reply) << stream_model::to_text(pdu);
        EXPECT_EQ(served.asked, pdu[0] == 0x2B and pdu.size() == 4 and pdu[2] == 4 ? 1U : 0U) << stream_model::to_text(pdu);
    }
    device served;
    EXPECT_TRUE(serve(byte_list(300, 0x42), served).empty());
}

TEST(rtu_server, does_not_care_how_its_buffers_are_aligned)
{
    auto const request = adu_of(17, "17 00 00 00 02 00 00 00 02 04 12 34 56 78"_hex);
    for (std::size_t from = 0; from < 4; ++from) {
        for (std::size_t to = 0; to < 4; ++to) {
            alignas(8) std::array<std::uint8_t, 64> in{};
            alignas(8) std::array<std::uint8_t, 64> out{};
            std::copy(request.begin(), request.end(), in.begin() + static_cast<std::ptrdiff_t>(from));
            device     served;
            auto const reply = rtu::serve(17, bytes{in}.subspan(from, request.size()), mutable_bytes{out}.subspan(to, 40), served);
            EXPECT_EQ(byte_list(reply.begin(), reply.end()), adu_of(17, "17 04 12 34 56 78"_hex));
        }
    }
}

TEST(rtu_server, answers_whatever_comes_with_a_valid_frame_or_not_at_all)
{
    rtu_model::dice random{99};
    for (unsigned trial = 0; trial < 5000; ++trial) {
        auto const function = rtu_model::random_function(random);
        auto const kind     = random.one_in(4) ? rtu_model::response : rtu_model::request;
        auto       pdu      = rtu_model::random_pdu(random, kind, function);
        if (random.one_in(3)) { pdu.resize(1 + random.below(pdu.size())); }
        if (pdu.size() > 4 and random.one_in(2)) { pdu[1] = pdu[3] = 0; }  // addresses and quantities that exist
        if (pdu.size() > 253) { continue; }
        device     served;
        auto const reply = serve(adu_of(17, pdu), served);
        if (pdu[0] == 8 and pdu.size() == 5 and pdu[1] == 0 and pdu[2] == 4) { continue; }
        ASSERT_GE(reply.size(), 5U) << stream_model::to_text(pdu);
        ASSERT_TRUE(rtu_model::is_intact(reply)) << stream_model::to_text(pdu);
        ASSERT_EQ(reply[0], 17);
        ASSERT_EQ(reply[1] & 0x7F, pdu[0]);
        ASSERT_TRUE((reply[1] & 0x80) != 0 or served.asked >= 1) << stream_model::to_text(pdu);
    }
}

//=== a function of one's own ===//

TEST(rtu_server, serves_and_polls_a_function_of_ones_own)
{
    using functions = modbus::public_functions::with<my_function>;
    auto const handler = overload{
        [](my_function::request const& r) { return my_function::response{bytes{vectors::diagnostics}.first(r.count)}; },
        [](modbus::read_exception_status::request const&) { return std::uint8_t{1}; },
    };
    static constexpr my_function::request asked{.count = 3};
    static constexpr auto                 request = rtu::encode(17, asked);
    static_assert(request.size() == 5);

    // The server's reader knows its length: no silence is needed.
    rtu::basic_reader<functions> reader{rtu::expecting::request};
    EXPECT_TRUE(reader.push(request).empty());
    auto const given = reader.next();
    ASSERT_NE(given.frame(), nullptr);
    std::array<std::uint8_t, 256> buffer{};
    auto const                    reply = rtu::serve<functions>(17, *given.frame(), buffer, handler);
    EXPECT_EQ(byte_list(reply.begin(), reply.end()), adu_of(17, "41 03 08 00 00"_hex));

    // The client's too.
    rtu::basic_reader<functions> listener{rtu::expecting::response};
    EXPECT_TRUE(listener.push(reply).empty());
    auto const heard = listener.next();
    ASSERT_NE(heard.frame(), nullptr);
    auto const answer = rtu::check(17, asked, heard.frame()->raw);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->data.size(), 3U);

    EXPECT_EQ(serve({request.begin(), request.end()}, handler), refusal(0x41, 1));  // not a public one
}

constexpr auto write_two = rtu::encode(17, write_single_register::request{.address = 1, .value = 2});

constexpr bool repeats_the_write()
{
    std::array<std::uint8_t, 16> buffer{};
    auto const                   handler = [](write_single_register::request const&) { return modbus::done{}; };
    return drivecodec::same_bytes(rtu::serve<void, modbus::crc16::bitwise>(17, write_two, buffer, handler), write_two);
}

TEST(rtu_server, serves_in_constant_expressions)
{
    VERIFY(repeats_the_write());
}

}  // namespace
