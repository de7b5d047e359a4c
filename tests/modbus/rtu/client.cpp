#include <drivecodec/modbus/rtu/client.hpp>

#include "support/exchanges.hpp"
#include "support/modbus_vectors.hpp"
#include "support/rtu_model.hpp"
#include "support/verify.hpp"

namespace {

namespace modbus = drivecodec::modbus;
namespace rtu    = drivecodec::modbus::rtu;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using modbus::read_holding_registers;
using modbus::write_single_register;
using rtu_model::adu_of;
using rtu_model::byte_list;

constexpr read_holding_registers::request four{{0x0C1E, 4}};

constexpr modbus::reply_error fault(errc code, std::size_t offset) { return error{code, offset}; }

//=== the right reply ===//

TEST(rtu_client, takes_the_printed_reply)
{
    static constexpr auto reply = rtu::check(2, four, vectors::xd1000_read_response);
    VERIFY(reply.has_value());
    VERIFY(reply->values.size() == 4 and reply->values[1] == 600);

    static constexpr write_single_register::request write{.address = 9001, .value = 13};
    VERIFY(rtu::check(2, write, vectors::xd1000_write_request).has_value());
}

TEST(rtu_client, takes_the_reply_to_every_request)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        auto const frame = adu_of(17, given.response);
        auto const reply = rtu::check(17, asked, bytes{frame});
        ASSERT_TRUE(reply) << function::name;
        EXPECT_TRUE(*reply == *drivecodec::decode<typename function::response>(given.response)) << function::name;
    });
}

TEST(rtu_client, takes_the_reply_of_a_reserved_address_if_that_was_asked)
{
    auto const frame = adu_of(250, "03 02 00 07"_hex);
    static constexpr read_holding_registers::request asked{{0, 1}};
    EXPECT_TRUE(rtu::check(rtu::server_address::reserved(250), asked, bytes{frame}));
    EXPECT_FALSE(rtu::check(rtu::server_address::reserved(251), asked, bytes{frame}));
}

//=== every other reply ===//

TEST(rtu_client, refuses_the_reply_of_every_other_server)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        for (int address = 0; address < 256; ++address) {
            auto const frame = adu_of(address, given.response);
            auto const reply = rtu::check(17, asked, bytes{frame});
            ASSERT_EQ(reply.has_value(), address == 17) << function::name;
            if (not reply) { ASSERT_EQ(reply.error(), fault(errc::unexpected_server, 0)) << function::name; }
        }
    });
}

TEST(rtu_client, refuses_the_exception_of_another_server)
{
    auto const frame = adu_of(18, "83 02"_hex);
    EXPECT_EQ(rtu::check(17, four, bytes{frame}).error(), fault(errc::unexpected_server, 0));
}

TEST(rtu_client, refuses_the_reply_to_every_other_function)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        exchanges::for_each([&asked](auto other) {
            if constexpr (not std::is_same_v<function, typename decltype(other)::function>) {
                auto const frame = adu_of(17, other.response);
                auto const reply = rtu::check(17, asked, bytes{frame});
                ASSERT_FALSE(reply) << function::name;
                ASSERT_EQ(reply.error().code(), errc::unexpected_function) << function::name;
                ASSERT_GE(reply.error().offset(), 1U);
            }
        });
    });
}

TEST(rtu_client, refuses_stale_replies)
{
    static constexpr auto stale_read = "02 03 06 00 28 02 58 01 F4"_hex;
    auto const            three      = rtu_model::with_crc({stale_read.begin(), stale_read.end()});
    EXPECT_EQ(rtu::check(2, four, bytes{three}).error(), fault(errc::unexpected_reply, 2));

    static constexpr write_single_register::request write{.address = 9001, .value = 13};
    auto const address = adu_of(2, "06 23 2A 00 0D"_hex);
    auto const value   = adu_of(2, "06 23 29 00 0E"_hex);
    EXPECT_EQ(rtu::check(2, write, bytes{address}).error(), fault(errc::unexpected_reply, 2));
    EXPECT_EQ(rtu::check(2, write, bytes{value}).error(), fault(errc::unexpected_reply, 4));

    static constexpr auto registers = modbus::write_multiple_registers::of(1, {2, 3});
    auto const            first     = adu_of(2, "10 00 02 00 02"_hex);
    auto const            count     = adu_of(2, "10 00 01 00 01"_hex);
    EXPECT_EQ(rtu::check(2, registers, bytes{first}).error(), fault(errc::unexpected_reply, 2));
    EXPECT_EQ(rtu::check(2, registers, bytes{count}).error(), fault(errc::unexpected_reply, 4));
}

TEST(rtu_client, refuses_every_flipped_bit_of_every_reply)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        for (auto const& whole : {adu_of(17, given.response), adu_of(17, byte_list{std::uint8_t(to_byte(function::code) | 0x80U), 2})}) {
            for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
                auto damaged = whole;
                damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
                auto const reply = rtu::check(17, asked, bytes{damaged});
                ASSERT_FALSE(reply) << function::name << ", bit " << bit;
                ASSERT_TRUE(reply.error() == fault(errc::bad_checksum, damaged.size() - 2)
                            or (reply.error().code() == errc::truncated and reply.error().offset() > damaged.size()))
                    << function::name << ", bit " << bit;
            }
        }
    });
}

TEST(rtu_client, refuses_every_truncation_of_every_reply)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        auto const whole = adu_of(17, given.response);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            byte_list const prefix(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            auto const      reply = rtu::check(17, asked, bytes{prefix});
            ASSERT_FALSE(reply) << function::name;
            if (function::response::length(given.response).is_until_silence() and size >= 5) { continue; }
            ASSERT_EQ(reply.error().code(), errc::truncated) << function::name << size;
            ASSERT_GT(reply.error().offset(), size) << function::name;
            ASSERT_LE(reply.error().offset(), whole.size()) << function::name;
        }
    });
}

/// A client that reads as many bytes as `truncated` says must not wait behind the end of an exception.
TEST(rtu_client, waits_for_no_more_than_an_exception_has)
{
    exchanges::for_each([](auto given) {
        using function   = typename decltype(given)::function;
        auto const asked = *drivecodec::decode<typename function::request>(given.request);
        auto const code  = static_cast<std::uint8_t>(drivecodec::modbus::to_byte(function::code) | 0x80U);
        auto const whole = rtu_model::adu_of(17, byte_list{code, 0x02});
        for (std::size_t size = 0; size < whole.size(); ++size) {
            auto const reply = rtu::check(17, asked, bytes{whole}.first(size));
            ASSERT_FALSE(reply) << function::name;
            EXPECT_EQ(reply.error(), (drivecodec::error{errc::truncated, whole.size()})) << function::name << size;
        }
        EXPECT_EQ(rtu::check(17, asked, bytes{whole}).error().code(), errc::exception_reply) << function::name;
        EXPECT_EQ(drivecodec::modbus::check_reply(asked, bytes{}).error(), (drivecodec::error{errc::truncated, 2}));
    });
}

TEST(rtu_client, refuses_a_reply_of_more_than_256_bytes)
{
    static constexpr modbus::report_server_id::request asked{};
    auto pdu = byte_list(254, 1);
    pdu[0]   = 0x11;
    pdu[1]   = 252;
    auto const frame = adu_of(1, pdu);
    EXPECT_FALSE(rtu::check(1, asked, bytes{frame}));
}

TEST(rtu_client, uses_the_crc_that_it_is_told_to_use)
{
    VERIFY(rtu::check<modbus::crc16::bitwise>(2, four, vectors::xd1000_read_response).has_value());
}

//=== exceptions ===//

TEST(rtu_client, is_told_of_every_exception)
{
    for (unsigned code = 0; code < 256; ++code) {
        auto const frame = adu_of(2, byte_list{0x83, static_cast<std::uint8_t>(code)});
        auto const reply = rtu::check(2, four, bytes{frame});
        ASSERT_FALSE(reply);
        ASSERT_EQ(reply.error().code(), errc::exception_reply) << code;
        ASSERT_EQ(static_cast<unsigned>(reply.error().exception()), code);
    }
}

TEST(rtu_client, refuses_an_exception_of_another_function)
{
    auto const frame = adu_of(2, "84 02"_hex);
    EXPECT_EQ(rtu::check(2, four, bytes{frame}).error(), fault(errc::unexpected_function, 1));
}

//=== no reply ===//

TEST(rtu_client, waits_for_no_reply_to_a_broadcast)
{
    static constexpr write_single_register::request write{.address = 9001, .value = 13};
    VERIFY(not rtu::expects_reply(rtu::broadcast, write));
    VERIFY(rtu::expects_reply(2, write));
    VERIFY(rtu::check(rtu::broadcast, write, vectors::xd1000_write_request).error() == fault(errc::no_reply, 0));
    VERIFY(rtu::check(rtu::broadcast, write, bytes{}).error() == fault(errc::no_reply, 0));
}

TEST(rtu_client, waits_for_no_reply_to_force_listen_only_mode)
{
    static constexpr auto silent = modbus::diagnostics::of(modbus::diagnostic::force_listen_only_mode);
    VERIFY(not rtu::expects_reply(2, silent));
    VERIFY(rtu::check(2, silent, bytes{}).error() == fault(errc::no_reply, 0));
}

//=== its own echo ===//

constexpr auto sent = vectors::xd1000_read_request;

TEST(rtu_client, skips_its_echo)
{
    auto received = byte_list(sent.begin(), sent.end());
    EXPECT_TRUE(rtu::skip_echo(sent, received)->empty());
    received.insert(received.end(), vectors::xd1000_read_response.begin(), vectors::xd1000_read_response.end());
    auto const rest = rtu::skip_echo(sent, received);
    ASSERT_TRUE(rest);
    EXPECT_EQ(rest->data(), received.data() + sent.size());
    EXPECT_TRUE(rtu::check(2, four, *rest));
    VERIFY(rtu::skip_echo(bytes{}, sent)->size() == 8);
}

TEST(rtu_client, waits_for_the_whole_echo)
{
    for (std::size_t size = 0; size < sent.size(); ++size) {
        EXPECT_EQ(rtu::skip_echo(sent, bytes{sent}.first(size)).error(), error(errc::truncated, sent.size()));
    }
}

TEST(rtu_client, sees_where_the_echo_is_none)
{
    for (std::size_t bit = 0; bit < 8 * sent.size(); ++bit) {
        auto received = byte_list(sent.begin(), sent.end());
        received[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        EXPECT_EQ(rtu::skip_echo(sent, received).error(), error(errc::unexpected_reply, bit / 8));
        received.resize(bit / 8 + 1);
        EXPECT_EQ(rtu::skip_echo(sent, received).error(), error(errc::unexpected_reply, bit / 8));
    }
}

/// A response that borrows from a temporary is refused by the compiler.
template <typename Request>
concept checks_temporaries = requires(Request asked) { rtu::check(rtu::server_address{1}, asked, byte_list{}); };
static_assert(not checks_temporaries<read_holding_registers::request>);

}  // namespace
