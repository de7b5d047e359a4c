#include <drivecodec/modbus/rtu/adu.hpp>

#include "support/exchanges.hpp"
#include "support/modbus_vectors.hpp"
#include "support/rtu_model.hpp"
#include "support/verify.hpp"

#include <drivecodec/modbus/crc16/byte_table.hpp>
#include <drivecodec/modbus/crc16/carryless.hpp>
#include <drivecodec/modbus/crc16/nibble.hpp>

namespace {

namespace modbus = drivecodec::modbus;
namespace crc16  = drivecodec::modbus::crc16;
namespace rtu    = drivecodec::modbus::rtu;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using drivecodec::same_bytes;
using modbus::read_coils;
using modbus::read_holding_registers;
using modbus::write_multiple_registers;
using modbus::write_single_register;
using rtu_model::adu_of;
using rtu_model::byte_list;

//=== frames that others printed ===//

constexpr read_holding_registers::request four_from_3102{{0x0C1E, 4}};
constexpr read_holding_registers::request three_from_107{{107, 3}};

TEST(rtu_adu, encodes_the_printed_frames)
{
    VERIFY(rtu::encode(2, four_from_3102) == vectors::xd1000_read_request);
    VERIFY(rtu::encode(2, write_single_register::request{.address = 9001, .value = 13}) == vectors::xd1000_write_request);
    VERIFY(rtu::encode(17, three_from_107) == vectors::introduction_read_request);

    using four_registers = read_holding_registers::basic_response<modbus::register_array<4>>;
    static constexpr four_registers response{.values = modbus::register_array<4>{{{40, 600, 500, 0}}}};
    VERIFY(rtu::encode(2, response) == vectors::xd1000_read_response);
}

TEST(rtu_adu, decodes_the_printed_frames)
{
    VERIFY(rtu::decode<read_holding_registers::request>(vectors::xd1000_read_request)->message == four_from_3102);
    VERIFY(rtu::decode<read_holding_registers::request>(vectors::introduction_read_request)->address.byte() == 17);
    VERIFY(rtu::decode<write_single_register::response>(vectors::xd1000_write_request)->message.value == 13);

    static constexpr auto response = rtu::decode<read_holding_registers::response>(vectors::xd1000_read_response);
    VERIFY(response->address.byte() == 2);
    VERIFY(response->message.values.size() == 4);
    VERIFY(response->message.values[1] == 600);
}

TEST(rtu_adu, has_its_crc_low_byte_first)
{
    VERIFY([] {
        std::array<std::uint8_t, 8> frame{0x02, 0x03, 0x0C, 0x1E, 0x00, 0x04};
        rtu::write_crc(frame);
        return frame == vectors::xd1000_read_request and rtu::has_valid_crc(frame);
    }());
    VERIFY(not rtu::has_valid_crc("02 03 0C 1E 00 04 6C 27"_hex));
}

TEST(rtu_adu, is_around_a_pdu_of_1_to_253_bytes)
{
    VERIFY(rtu::min_adu_size == 4);
    VERIFY(rtu::max_adu_size == 256);
    VERIFY(same_bytes(rtu::pdu_of(vectors::xd1000_read_request), "03 0C 1E 00 04"_hex));
}

//=== every algorithm ===//

template <typename Crc>
class rtu_adu_with : public testing::Test {};
constexpr auto wrong_crc = "11 03 00 6B 00 03 76 86"_hex;
using algorithms         = testing::Types<crc16::bitwise, crc16::nibble, crc16::byte_table, crc16::slices, crc16::carryless>;
TYPED_TEST_SUITE(rtu_adu_with, algorithms);

TYPED_TEST(rtu_adu_with, the_algorithm_is_the_same)
{
    VERIFY(rtu::encode<TypeParam>(17, three_from_107) == vectors::introduction_read_request);
    VERIFY(rtu::encode<TypeParam>(rtu::broadcast, write_single_register::request{1, 2})
           == rtu::encode(rtu::broadcast, write_single_register::request{1, 2}));
    VERIFY(rtu::decode<read_holding_registers::request, TypeParam>(vectors::introduction_read_request).has_value());
    VERIFY(rtu::decode<read_holding_registers::request, TypeParam>(wrong_crc).error()
           == error{errc::bad_checksum, 6});

    std::array<std::uint8_t, 8> out{};
    auto const written = rtu::encode<TypeParam>(17, three_from_107, out);
    ASSERT_TRUE(written);
    EXPECT_EQ(out, vectors::introduction_read_request);
    EXPECT_TRUE(rtu::encode<TypeParam>(rtu::broadcast, write_single_register::request{1, 2}, out));
}

//=== what is refused ===//

/// Every prefix is truncated, and says how much is missing at least; the longest says it exactly.
template <typename Message>
void refuses_every_truncation(byte_list const& whole)
{
    ASSERT_TRUE(rtu::decode<Message>(bytes{whole})) << stream_model::to_text(whole);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        byte_list const prefix(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        auto const      refused = rtu::decode<Message>(bytes{prefix});
        ASSERT_FALSE(refused) << size << " of " << stream_model::to_text(whole);
        auto const needs = std::size_t{refused.error().offset()};
        if (refused.error().code() == errc::truncated) {
            ASSERT_GT(needs, size) << stream_model::to_text(whole);
            ASSERT_LE(needs, whole.size()) << stream_model::to_text(whole);
        } else {  // a length that only the silence tells, or a prefix that is wrong as a PDU
            ASSERT_EQ(refused.error(), error(errc::bad_checksum, size - 2)) << stream_model::to_text(prefix);
            auto const length = Message::length(bytes{whole}.subspan(1));
            ASSERT_TRUE(length.is_until_silence()) << size << ": " << stream_model::to_text(whole);
        }
    }
}

template <typename Message>
void refuses_every_flipped_bit(byte_list const& whole)
{
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        auto damaged = whole;
        damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        auto const refused = rtu::decode<Message>(bytes{damaged});
        ASSERT_FALSE(refused) << stream_model::to_text(damaged);
        if (refused.error().code() == errc::truncated) {
            ASSERT_GT(refused.error().offset(), damaged.size()) << stream_model::to_text(damaged);
        } else {
            ASSERT_EQ(refused.error(), error(errc::bad_checksum, damaged.size() - 2)) << stream_model::to_text(damaged);
        }
    }
}

TEST(rtu_adu, refuses_every_truncation_of_every_message)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        refuses_every_truncation<typename function::request>(adu_of(17, given.request));
        refuses_every_truncation<typename function::response>(adu_of(17, given.response));
    });
}

TEST(rtu_adu, refuses_every_flipped_bit_of_every_message)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        refuses_every_flipped_bit<typename function::request>(adu_of(17, given.request));
        refuses_every_flipped_bit<typename function::response>(adu_of(17, given.response));
    });
    refuses_every_flipped_bit<read_holding_registers::request>(
        {vectors::xd1000_read_request.begin(), vectors::xd1000_read_request.end()});
    refuses_every_flipped_bit<read_holding_registers::response>(
        {vectors::xd1000_read_response.begin(), vectors::xd1000_read_response.end()});
    refuses_every_flipped_bit<write_single_register::request>(
        {vectors::xd1000_write_request.begin(), vectors::xd1000_write_request.end()});
    refuses_every_flipped_bit<read_holding_registers::request>(
        {vectors::introduction_read_request.begin(), vectors::introduction_read_request.end()});
}

TEST(rtu_adu, says_how_long_it_must_be_at_least)
{
    VERIFY(rtu::decode<read_holding_registers::request>(bytes{}).error().code() == errc::truncated);
    VERIFY(rtu::decode<read_holding_registers::request>("11 03 00"_hex).error() == error{errc::truncated, 8});
    VERIFY(rtu::decode<read_holding_registers::request>("11 03 00 6B 00 03 76"_hex).error() == error{errc::truncated, 8});
    static constexpr auto begun = "02 03 08 00 28 02 58 01 F4"_hex;
    VERIFY(rtu::decode<read_holding_registers::response>(bytes{begun}).error() == error{errc::truncated, 13});
}

TEST(rtu_adu, refuses_a_byte_too_many)
{
    exchanges::for_each([](auto given) {
        using function = typename decltype(given)::function;
        auto pdu   = byte_list(given.request.begin(), given.request.end());
        auto whole = adu_of(17, pdu);
        whole.push_back(1);  // a zero would leave the CRC right
        EXPECT_FALSE(rtu::decode<typename function::request>(bytes{whole})) << function::name;

        if (function::request::length(pdu).is_until_silence()) { return; }
        pdu.push_back(0);
        auto const longer = adu_of(17, pdu);
        EXPECT_EQ(rtu::decode<typename function::request>(bytes{longer}).error(),
                  error(errc::trailing_bytes, 1 + given.request.size()))
            << function::name;
    });
}

TEST(rtu_adu, tells_a_damaged_line_from_a_wrong_message)
{
    auto const coil = adu_of(1, "05 00 00 12 34"_hex);
    EXPECT_EQ(rtu::decode<modbus::write_single_coil::request>(bytes{coil}).error(), error(errc::bad_value, 4));
    auto const too_many = adu_of(1, "03 00 00 00 7E"_hex);
    EXPECT_EQ(rtu::decode<read_holding_registers::request>(bytes{too_many}).error(), error(errc::bad_quantity, 4));
    EXPECT_EQ(rtu::decode<write_single_register::request>(bytes{too_many}).error(), error(errc::unexpected_function, 1));
    auto damaged = too_many;
    damaged[7] ^= 1;
    EXPECT_EQ(rtu::decode<read_holding_registers::request>(bytes{damaged}).error(), error(errc::bad_checksum, 6));
}

//=== limits ===//

TEST(rtu_adu, takes_256_bytes_and_no_more)
{
    auto pdu = byte_list(253, 0x07);
    pdu[0]   = 0x2B;
    pdu[1]   = 0x0D;
    using canopen  = modbus::canopen_general_reference;
    auto const max = adu_of(5, pdu);
    ASSERT_EQ(max.size(), 256U);
    auto const decoded = rtu::decode<canopen::request>(bytes{max});
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded->message.payload().size(), 251U);

    byte_list out(256);
    ASSERT_TRUE(rtu::encode(5, decoded->message, out));
    EXPECT_EQ(out, max);

    pdu.push_back(7);
    auto const too_long = adu_of(5, pdu);
    EXPECT_EQ(rtu::decode<canopen::request>(bytes{too_long}).error().code(), errc::trailing_bytes);
    byte_list const far_too_long(70'000, 0x2B);
    EXPECT_FALSE(rtu::decode<canopen::request>(bytes{far_too_long}));
}

TEST(rtu_adu, writes_nothing_where_there_is_no_space)
{
    std::array<std::uint16_t, 123> words{};
    auto const                     request = *write_multiple_registers::request::make(0, words);
    for (std::size_t size = 0; size < 255; ++size) {
        byte_list out(size, 0xEE);
        auto const refused = rtu::encode(1, request, out);
        ASSERT_FALSE(refused);
        ASSERT_EQ(refused.error(), error(errc::no_space, 255));
        ASSERT_EQ(out, byte_list(size, 0xEE));
    }
    byte_list  out(300, 0xEE);
    auto const written = rtu::encode(1, request, out);
    ASSERT_TRUE(written);
    EXPECT_EQ(written->size(), 255U);
    EXPECT_EQ(written->data(), out.data());
    EXPECT_TRUE(rtu_model::is_intact(*written));
    EXPECT_EQ(byte_list(out.begin() + 255, out.end()), byte_list(45, 0xEE));
    EXPECT_EQ(rtu::encode(rtu::broadcast, request, std::span{out}.first(254)).error(), error(errc::no_space, 255));
}

TEST(rtu_adu, is_what_the_model_says_for_every_message)
{
    exchanges::for_each([](auto given) {
        using function      = typename decltype(given)::function;
        auto const check = [](auto type, bytes pdu) {
            using message      = typename decltype(type)::type;
            auto const decoded = drivecodec::decode<message>(pdu);
            ASSERT_TRUE(decoded) << function::name;
            for (int address : {0, 1, 17, 247, 248, 255}) {
                auto const whole = adu_of(address, pdu);
                byte_list  out(whole.size());
                auto const to = rtu::server_address::reserved(static_cast<std::uint8_t>(address));
                ASSERT_TRUE(rtu::encode(to, *decoded, out)) << function::name;
                ASSERT_EQ(out, whole) << function::name;
                auto const again = rtu::decode<message>(bytes{whole});
                ASSERT_TRUE(again) << function::name;
                ASSERT_EQ(again->address.byte(), address);
                ASSERT_TRUE(again->message == *decoded) << function::name;
            }
        };
        check(std::type_identity<typename function::request>{}, given.request);
        check(std::type_identity<typename function::response>{}, given.response);
    });
}

//=== addresses ===//

TEST(rtu_adu, broadcasts_writes)
{
    static constexpr auto frame = rtu::encode(rtu::broadcast, write_single_register::request{.address = 1, .value = 2});
    VERIFY(frame[0] == 0);
    VERIFY(rtu::decode<write_single_register::request>(frame)->address.is_broadcast());
    static constexpr auto several = rtu::encode(rtu::broadcast, write_multiple_registers::of(0, {1, 2, 3}));
    VERIFY(several.size() == 15 and several[0] == 0);
}

TEST(rtu_adu, decodes_reserved_addresses)
{
    static constexpr auto frame
        = rtu::encode(rtu::server_address::reserved(248), write_single_register::request{.address = 1, .value = 2});
    VERIFY(frame[0] == 248);
    VERIFY(rtu::decode<write_single_register::request>(frame)->address.is_reserved());
}

//=== constants ===//

TEST(rtu_adu, is_a_constant_where_the_size_is_known)
{
    static constexpr auto registers = rtu::encode(1, write_multiple_registers::of(0x0001, {0x000A, 0x0102}));
    static constexpr auto exchange  = rtu::encode(1, modbus::read_write_multiple_registers::of({3, 6}, 14, {1, 2, 3}));
    static constexpr auto coils     = rtu::encode(1, modbus::write_multiple_coils::of(19, {true, false, true}));
    static constexpr auto records   = rtu::encode(1, modbus::write_file_record::of(4, 7, {0x06AF, 0x04BE, 0x100D}));
    VERIFY(registers.size() == 13 and rtu::has_valid_crc(registers));
    VERIFY(exchange.size() == 19 and rtu::has_valid_crc(exchange));
    VERIFY(coils.size() == 10 and rtu::has_valid_crc(coils));
    VERIFY(records.size() == 18 and rtu::has_valid_crc(records));
    using request_adu = rtu::adu<read_coils::request>;
    static_assert(drivecodec::codec<request_adu> and drivecodec::fixed_size<request_adu>);
    static_assert(request_adu::wire_size() == 8);
    static constexpr request_adu eight{1, {{0, 8}}};
    static constexpr request_adu nine{1, {{0, 9}}};
    VERIFY(eight == eight);
    VERIFY(not(eight == nine));
}

/// A temporary that the compiler must refuse, since the message borrows it; a fixed-size message does not.
template <typename Message>
concept decodes_temporaries = requires { rtu::decode<Message>(std::vector<std::uint8_t>{}); };
static_assert(not decodes_temporaries<read_holding_registers::response>);
static_assert(not decodes_temporaries<write_multiple_registers::request>);
static_assert(decodes_temporaries<read_holding_registers::request>);

}  // namespace
