#include <drivecodec/modbus/client.hpp>

#include "support/exchanges.hpp"
#include "support/verify.hpp"

#include <vector>

namespace {

using namespace drivecodec::modbus;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using byte_list = std::vector<std::uint8_t>;

byte_list list_of(bytes from) { return {from.begin(), from.end()}; }

constexpr reply_error fault(errc code, std::size_t offset) { return error{code, offset}; }

//=== the right reply ===//

TEST(client, takes_the_reply_to_every_request)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        auto const asked = drivecodec::decode<typename function::request>(given.request);
        ASSERT_TRUE(asked) << function::name;
        auto const reply = check_reply(*asked, given.response);
        ASSERT_TRUE(reply) << function::name;
        EXPECT_TRUE(*reply == *drivecodec::decode<typename function::response>(given.response)) << function::name;
    });
}

TEST(client, gives_values_of_a_reply_as_a_constant)
{
    static constexpr read_holding_registers::request asked{{107, 3}};
    static constexpr auto                            reply = check_reply(asked, vectors::read_holding_registers_response);
    VERIFY(reply.has_value());
    VERIFY(reply->values[0] == 0x022B);
    VERIFY(reply->values[2] == 0x0064);
}

TEST(client, takes_the_reply_to_a_constant_write)
{
    static constexpr auto asked = write_multiple_registers::of(1, {0x000A, 0x0102});
    VERIFY(check_reply(asked, vectors::write_multiple_registers_response).has_value());
    static constexpr auto other = write_multiple_registers::of(1, {0x000A, 0x0102, 0x0103});
    VERIFY(check_reply(other, vectors::write_multiple_registers_response).error() == fault(errc::unexpected_reply, 3));
}

//=== every other reply ===//

TEST(client, refuses_the_reply_to_every_other_function)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        exchanges::for_each([&asked](auto other) {
            using other_function = typename decltype(other)::function;
            if constexpr (not std::is_same_v<function, other_function>) {
                auto const reply = check_reply(asked, other.response);
                ASSERT_FALSE(reply) << function::name << ": " << other_function::name;
                auto const shares_code = function::code == other_function::code;
                ASSERT_EQ(reply.error(), fault(errc::unexpected_function, shares_code ? 1 : 0)) << function::name;
            }
        });
    });
}

TEST(client, refuses_every_truncated_reply)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        for (std::size_t size = 0; size < given.response.size(); ++size) {
            auto const prefix = list_of(given.response.first(size));
            auto const reply  = check_reply(asked, prefix);
            if (size >= 2 and function::response::length(given.response).is_until_silence()) { continue; }
            ASSERT_FALSE(reply) << function::name;
            ASSERT_EQ(reply.error().code(), errc::truncated) << function::name << size;
            ASSERT_GT(reply.error().offset(), size) << function::name;
            ASSERT_LE(reply.error().offset(), given.response.size()) << function::name;
        }
    });
}

TEST(client, refuses_a_longer_reply)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        if (function::response::length(given.response).is_until_silence()) { return; }
        auto longer = list_of(given.response);
        longer.push_back(0);
        EXPECT_EQ(check_reply(asked, longer).error(), fault(errc::trailing_bytes, given.response.size())) << function::name;
    });
}

TEST(client, refuses_a_reply_of_another_quantity)
{
    constexpr read_holding_registers::request three{{107, 3}};
    for (std::uint8_t count = 1; count <= 125; ++count) {
        byte_list pdu(2U + 2U * count);
        pdu[0] = 0x03;
        pdu[1] = static_cast<std::uint8_t>(2 * count);
        if (count == 3) {
            EXPECT_TRUE(check_reply(three, pdu));
        } else {
            EXPECT_EQ(check_reply(three, pdu).error(), fault(errc::unexpected_reply, 1)) << int{count};
        }
    }
    constexpr read_coils::request nineteen{{0, 19}};
    for (std::uint8_t size = 1; size <= 250; ++size) {
        byte_list pdu(2U + size);
        pdu[0] = 0x01;
        pdu[1] = size;
        if (size == 3) {
            EXPECT_TRUE(check_reply(nineteen, pdu));
        } else {
            EXPECT_EQ(check_reply(nineteen, pdu).error(), fault(errc::unexpected_reply, 1)) << int{size};
        }
    }
    constexpr auto six = "17 00 03 00 06 00 0E 00 03 06 00 FF 00 FF 00 FF"_hex;
    auto const     asked = *drivecodec::decode<read_write_multiple_registers::request>(six);
    EXPECT_EQ(check_reply(asked, bytes{"17 0A 00 00 00 00 00 00 00 00 00 00"_hex}).error(), fault(errc::unexpected_reply, 1));
}

/// A reply that differs in any bit from what repeats the request is not taken.
template <typename Function>
void refuses_every_other_echo(bytes request, bytes response)
{
    auto const asked = *drivecodec::decode<typename Function::request>(request);
    ASSERT_TRUE(check_reply(asked, response));
    for (std::size_t bit = 0; bit < 8 * response.size(); ++bit) {
        auto other = list_of(response);
        other[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        auto const reply = check_reply(asked, other);
        ASSERT_FALSE(reply) << Function::name << ", bit " << bit;
    }
}

TEST(client, refuses_every_other_echo)
{
    refuses_every_other_echo<write_single_coil>(vectors::write_single_coil, vectors::write_single_coil);
    refuses_every_other_echo<write_single_register>(vectors::write_single_register, vectors::write_single_register);
    refuses_every_other_echo<diagnostics>(vectors::diagnostics, vectors::diagnostics);
    refuses_every_other_echo<write_multiple_coils>(vectors::write_multiple_coils_request,
                                                   vectors::write_multiple_coils_response);
    refuses_every_other_echo<write_multiple_registers>(vectors::write_multiple_registers_request,
                                                       vectors::write_multiple_registers_response);
    refuses_every_other_echo<write_file_record>(vectors::write_file_record, vectors::write_file_record);
    refuses_every_other_echo<mask_write_register>(vectors::mask_write_register, vectors::mask_write_register);
}

TEST(client, says_which_field_differs)
{
    static constexpr write_single_coil::request     coil{.address = 172, .value = true};
    static constexpr write_single_register::request one{.address = 1, .value = 3};
    static constexpr mask_write_register::request   mask{.address = 4, .and_mask = 0xF2, .or_mask = 0x25};
    VERIFY(check_reply(coil, bytes{"05 00 AD FF 00"_hex}).error() == fault(errc::unexpected_reply, 1));
    VERIFY(check_reply(coil, bytes{"05 00 AC 00 00"_hex}).error() == fault(errc::unexpected_reply, 3));
    VERIFY(check_reply(coil, bytes{"05 00 AC 12 34"_hex}).error() == fault(errc::bad_value, 3));
    VERIFY(check_reply(one, bytes{"06 00 02 00 03"_hex}).error() == fault(errc::unexpected_reply, 1));
    VERIFY(check_reply(one, bytes{"06 00 01 00 04"_hex}).error() == fault(errc::unexpected_reply, 3));
    VERIFY(check_reply(mask, bytes{"16 00 05 00 F2 00 25"_hex}).error() == fault(errc::unexpected_reply, 1));
    VERIFY(check_reply(mask, bytes{"16 00 04 00 F3 00 25"_hex}).error() == fault(errc::unexpected_reply, 3));
    VERIFY(check_reply(mask, bytes{"16 00 04 00 F2 00 26"_hex}).error() == fault(errc::unexpected_reply, 5));
}

TEST(client, takes_the_value_of_a_counter_but_of_no_other)
{
    static constexpr auto asked = diagnostics::of(diagnostic::return_bus_message_count);
    VERIFY(check_reply(asked, bytes{"08 00 0B 12 34"_hex})->data()[0] == 0x1234);
    VERIFY(check_reply(asked, bytes{"08 00 0C 12 34"_hex}).error() == fault(errc::unexpected_reply, 1));
    static constexpr auto loop = diagnostics::of(diagnostic::return_query_data, {0xA537, 0x0102});
    VERIFY(check_reply(loop, bytes{"08 00 00 A5 37 01 02"_hex}).has_value());
    VERIFY(check_reply(loop, bytes{"08 00 00 A5 37 01 03"_hex}).error() == fault(errc::unexpected_reply, 3));
    VERIFY(check_reply(loop, bytes{"08 00 00 A5 37"_hex}).error() == fault(errc::unexpected_reply, 3));
}

TEST(client, takes_the_records_and_objects_that_it_asked_for)
{
    auto const files = *drivecodec::decode<read_file_record::request>(vectors::read_file_record_request);
    EXPECT_FALSE(check_reply(files, bytes{"14 06 05 06 0D FE 00 20"_hex}));                                 // one is missing
    EXPECT_FALSE(check_reply(files, bytes{"14 0C 03 06 0D FE 07 06 33 CD 00 40 00 00"_hex}));               // of other lengths
    EXPECT_FALSE(check_reply(files, bytes{"14 12 05 06 0D FE 00 20 05 06 33 CD 00 40 05 06 33 CD 00 40"_hex}));  // one too many

    constexpr read_device_identification::request one{read_device_id_code::specific, 2};
    EXPECT_TRUE(check_reply(one, bytes{"2B 0E 04 83 00 00 01 02 01 41"_hex}));
    EXPECT_FALSE(check_reply(one, bytes{"2B 0E 04 83 00 00 01 03 01 41"_hex}));
    EXPECT_FALSE(check_reply(one, bytes{"2B 0E 01 83 00 00 01 02 01 41"_hex}));
    EXPECT_FALSE(check_reply(one, bytes{"2B 0E 04 83 00 00 02 02 01 41 03 00"_hex}));
}

//=== exceptions ===//

TEST(client, is_told_of_every_exception)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        for (unsigned code = 0; code < 256; ++code) {
            byte_list const pdu{static_cast<std::uint8_t>(to_byte(function::code) | 0x80), static_cast<std::uint8_t>(code)};
            auto const      reply = check_reply(asked, pdu);
            ASSERT_FALSE(reply) << function::name;
            ASSERT_EQ(reply.error().code(), errc::exception_reply) << function::name << code;
            ASSERT_EQ(static_cast<unsigned>(reply.error().exception()), code) << function::name;
            ASSERT_EQ(reply.error(), reply_error{static_cast<exception_code>(code)});
        }
    });
}

TEST(client, refuses_an_exception_of_another_function)
{
    constexpr read_holding_registers::request asked{{107, 3}};
    for (unsigned function = 0x80; function < 0x100; ++function) {
        if (function == 0x83) { continue; }
        byte_list const pdu{static_cast<std::uint8_t>(function), 2};
        EXPECT_EQ(check_reply(asked, pdu).error(), fault(errc::unexpected_function, 0)) << function;
    }
}

TEST(client, refuses_an_exception_of_another_length)
{
    static constexpr read_holding_registers::request asked{{107, 3}};
    VERIFY(check_reply(asked, bytes{"83"_hex}).error() == fault(errc::truncated, 2));
    VERIFY(check_reply(asked, bytes{"83 02 00"_hex}).error() == fault(errc::trailing_bytes, 2));
    VERIFY(check_reply(asked, bytes{"83 02"_hex}).error().exception() == exception_code::illegal_data_address);
}

TEST(client, is_told_of_exceptions_of_function_43_in_both_forms)
{
    static constexpr read_device_identification::request asked{read_device_id_code::basic};
    VERIFY(check_reply(asked, bytes{"AB 02"_hex}).error() == reply_error{exception_code::illegal_data_address});
    VERIFY(check_reply(asked, bytes{"AB 0E 02"_hex}).error() == reply_error{exception_code::illegal_data_address});
    VERIFY(check_reply(asked, bytes{"AB 0E 02 00"_hex}).error().code() == errc::trailing_bytes);
}

//=== no reply ===//

TEST(client, waits_for_no_reply_to_force_listen_only_mode)
{
    static constexpr auto silent = diagnostics::of(diagnostic::force_listen_only_mode);
    VERIFY(not expects_reply(silent));
    VERIFY(check_reply(silent, bytes{"08 00 04 00 00"_hex}).error() == fault(errc::no_reply, 0));
    static constexpr auto restart = diagnostics::of(diagnostic::restart_communications_option);
    VERIFY(expects_reply(restart));
}

//=== errors ===//

TEST(client_reply_error, is_an_error_or_an_exception)
{
    constexpr reply_error broken{error{errc::bad_length, 7}};
    VERIFY(broken.code() == errc::bad_length and broken.offset() == 7);
    constexpr reply_error refusal{exception_code::server_device_busy};
    VERIFY(refusal.code() == errc::exception_reply and refusal.exception() == exception_code::server_device_busy);
    VERIFY(not(broken == refusal));
    VERIFY(not(refusal == reply_error{exception_code::acknowledge}));
}

}  // namespace
