#include <drivecodec/modbus/rtu/framing.hpp>

#include "support/hex.hpp"
#include "support/pdu_vectors.hpp"
#include "support/rtu_model.hpp"
#include "support/verify.hpp"

#include <drivecodec/core/deframer.hpp>

namespace {

namespace modbus = drivecodec::modbus;
namespace rtu    = drivecodec::modbus::rtu;
using drivecodec::bytes;
using drivecodec::message_length;
using modbus::direction;
using rtu::expecting;
using rtu::framing;
using rtu_model::adu_of;
using rtu_model::byte_list;

static_assert(drivecodec::framing<framing<>>);

constexpr auto read_two = "01 03 00 00 00 02 C4 0B"_hex;

//=== frames ===//

TEST(rtu_frame, gives_its_parts)
{
    static constexpr auto    raw = "05 83 02 81 30"_hex;
    static constexpr rtu::frame whole{.raw = raw, .direction = direction::response, .aligned = true};
    VERIFY(whole.address() == 5);
    VERIFY(whole.pdu().size() == 2);
    VERIFY(whole.function() == modbus::function_code::read_holding_registers);
    VERIFY(whole.is_exception());

    static constexpr rtu::frame asked{.raw = read_two, .direction = direction::request, .aligned = true};
    VERIFY(asked.function() == modbus::function_code::read_holding_registers);
    VERIFY(not asked.is_exception());
}

//=== lengths ===//

/// What a framing that has heard nothing says, compared with what the specification says.
void compare_lengths(bytes front)
{
    auto const expected = rtu_model::rules{}.readings(front);
    auto       wanted   = expected.begin();
    for (unsigned reading = 0; reading < framing<>::max_readings; ++reading) {
        auto const length = framing<>{}.length(front, reading);
        if (reading == 1) {
            ASSERT_TRUE(length.is_impossible());
            continue;
        }
        if (wanted == expected.end()) {
            ASSERT_TRUE(length.is_impossible()) << stream_model::to_text(front) << reading;
            continue;
        }
        auto const context = stream_model::to_text(front) + std::to_string(reading);
        ASSERT_EQ(length.is_exact(), wanted->says == rtu_model::what::has_size) << context;
        ASSERT_EQ(length.is_until_silence(), wanted->says == rtu_model::what::until_silence) << context;
        ASSERT_EQ(length.is_impossible(), wanted->says == rtu_model::what::impossible) << context;
        if (length.is_exact()) {
            ASSERT_EQ(length.size() <= 256, wanted->size <= 256) << context;
            if (wanted->size <= 256) { ASSERT_EQ(length.size(), wanted->size) << context; }
        }
        if (length.is_open()) { ASSERT_GT(length.size(), front.size()) << context; }
        ++wanted;
    }
}

TEST(rtu_framing, knows_the_length_of_every_function)
{
    rtu_model::dice random{3};
    for (int function = 0; function < 256; ++function) {
        for (int round = 0; round < 40; ++round) {
            auto front = random.noise(2 + random.below(20));
            front[1]   = static_cast<std::uint8_t>(function);
            if (front.size() > 3 and round % 2 == 0) { front[2] = 0; }
            if (front.size() > 3 and function == 0x2B) { front[2] = static_cast<std::uint8_t>(12 + round % 4); }
            ASSERT_NO_FATAL_FAILURE(compare_lengths(front));
        }
    }
}

TEST(rtu_framing, knows_the_lengths_of_the_printed_examples)
{
    for (auto const& printed : vectors::printed_requests) {
        auto const whole = adu_of(17, printed.pdu);
        auto const length = framing<>{expecting::request}.length(whole, 0);
        EXPECT_TRUE(length == message_length::exactly(whole.size()) or length.is_until_silence()) << printed.name;
    }
    for (auto const& printed : vectors::printed_responses) {
        auto const whole = adu_of(17, printed.pdu);
        auto const length = framing<>{expecting::response}.length(whole, 0);
        EXPECT_TRUE(length == message_length::exactly(whole.size()) or length.is_until_silence()) << printed.name;
    }
}

TEST(rtu_framing, waits_for_the_function)
{
    VERIFY(framing<>{}.length({}, 0) == message_length::at_least(2));
    VERIFY(framing<>{}.length(bytes{read_two}.first(1), 3) == message_length::at_least(2));
}

TEST(rtu_framing, finds_nothing_impossible_but_lengths)
{
    VERIFY(framing<>{}.length("01 03 00 00 00 7E C5 EA"_hex, 0) == message_length::exactly(8));  // 126 registers
    VERIFY(framing<>{}.length("01 05 00 00 12 34"_hex, 0) == message_length::exactly(8));        // neither on nor off
    VERIFY(framing<>{}.length("01 10 00 00 00 00 03"_hex, 0) == message_length::exactly(12));    // odd byte count
    VERIFY(framing<>{}.length("01 10 00 00 00 00 FF"_hex, 0) == message_length::exactly(264));
}

TEST(rtu_framing, does_not_wrap_around_at_lengths_beyond_16_bits)
{
    for (auto const& front : {"01 18 FF FB 00"_hex, "01 18 FF FD 00"_hex, "01 18 FF FE 00"_hex, "01 18 FF FF 00"_hex}) {
        auto const length = framing<>{expecting::response}.length(front, 0);
        EXPECT_TRUE(length.is_exact());
        EXPECT_GT(length.size(), 256U);
    }
}

//=== readings ===//

constexpr direction first_direction_of(framing<> const& scheme, bytes raw)
{
    auto copy = scheme;
    return copy.accept(raw, 0, true).direction;
}

constexpr framing<> after(bytes frame, framing<> scheme = framing<>{})
{
    static_cast<void>(scheme.accept(frame, 0, true));
    return scheme;
}

constexpr auto refusal  = "01 83 02 C0 F1"_hex;
constexpr auto mei_long = "01 AB 0E 02 00 00"_hex;

TEST(rtu_framing, reads_a_response_first_only_behind_its_request)
{
    VERIFY(first_direction_of(framing<>{}, read_two) == direction::request);
    VERIFY(first_direction_of(after(read_two), read_two) == direction::response);
    VERIFY(first_direction_of(after(read_two), refusal) == direction::response);
    VERIFY(first_direction_of(after(read_two), "02 03 00 00 00 02 C4 38"_hex) == direction::request);
    VERIFY(first_direction_of(after(read_two), "01 04 00 00 00 02 71 CB"_hex) == direction::request);
    VERIFY(first_direction_of(after(read_two, after(read_two)), read_two) == direction::request);
    VERIFY(first_direction_of(after("00 06 00 01 00 02 58 1A"_hex), "00 06 00 01 00 02 58 1A"_hex) == direction::request);
    VERIFY(first_direction_of(after("01 08 00 04 00 00 A1 C9"_hex), "01 08 00 04 00 00 A1 C9"_hex) == direction::request);
}

TEST(rtu_framing, forgets_the_request_that_timed_out)
{
    VERIFY([] {
        auto scheme = after(read_two);
        scheme.request_timed_out();
        return first_direction_of(scheme, read_two) == direction::request;
    }());
}

TEST(rtu_framing, has_one_direction_if_it_expects_one)
{
    VERIFY(first_direction_of(after(read_two, framing<>{expecting::request}), read_two) == direction::request);
    VERIFY(first_direction_of(framing<>{expecting::response}, read_two) == direction::response);
    VERIFY(framing<>{expecting::request}.length(read_two, 2).is_impossible());
    VERIFY(framing<>{expecting::response}.length(read_two, 2).is_impossible());
    VERIFY(framing<>{}.length(read_two, 2) == message_length::exactly(5));  // a response without data
}

TEST(rtu_framing, has_requests_only_for_its_own_address)
{
    constexpr framing<> own{expecting::either, 1};
    VERIFY(first_direction_of(after(read_two, own), read_two) == direction::request);
    VERIFY(own.length(read_two, 2).is_impossible());
    VERIFY(own.length("02 03 00 00 00 02 C4 38"_hex, 2) == message_length::exactly(5));
}

TEST(rtu_framing, has_two_lengths_for_a_refusal_of_function_43)
{
    VERIFY(framing<>{expecting::response}.length(mei_long, 0) == message_length::exactly(5));
    VERIFY(framing<>{expecting::response}.length(mei_long, 1) == message_length::exactly(6));
    VERIFY(framing<>{}.length(mei_long, 0).is_impossible());
    VERIFY(framing<>{}.length(mei_long, 1).is_impossible());
    VERIFY(framing<>{}.length(mei_long, 2) == message_length::exactly(5));
    VERIFY(framing<>{}.length(mei_long, 3) == message_length::exactly(6));
    VERIFY(framing<>{expecting::response}.length(refusal, 1).is_impossible());
}

TEST(rtu_framing, verifies_the_crc)
{
    VERIFY(framing<>::is_intact(read_two));
    VERIFY(not framing<>::is_intact("01 03 00 00 00 02 0B C4"_hex));
}

}  // namespace
