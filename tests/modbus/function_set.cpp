#include <drivecodec/modbus/function_set.hpp>

#include <drivecodec/core/overload.hpp>
#include <drivecodec/modbus/functions.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <string_view>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;
using namespace std::string_view_literals;

//=== a vendor's own function: | 41 | channel | -> | 41 | channel | byte count | samples ... | ===//

struct read_trace {
    static constexpr auto        code = static_cast<function_code>(0x41);
    static constexpr char const* name = "read_trace";

    struct response {
        using function = read_trace;

        std::uint8_t channel;
        bytes        samples;

        [[nodiscard]] constexpr std::size_t           wire_size() const noexcept { return 3 + samples.size(); }
        [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
        {
            return pdu.size() < 3 ? message_length::at_least(3) : message_length::exactly(3 + std::size_t{pdu[2]});
        }
        [[nodiscard]] static constexpr error check(bytes pdu) noexcept
        {
            auto const fault = check_head(pdu, code, 3, 3);
            return fault.ok() ? check_size(pdu, length(pdu).size()) : fault;
        }
        [[nodiscard]] static constexpr response read(bytes pdu) noexcept { return {pdu[1], pdu.subspan(3)}; }
        constexpr void                          write(mutable_bytes out) const noexcept
        {
            u8_at<0>::store(out, to_byte(code));
            u8_at<1>::store(out, channel);
            u8_at<2>::store(out, static_cast<std::uint8_t>(samples.size()));
            copy_bytes(samples, out.subspan(3));
        }
    };

    struct request {
        using function = read_trace;

        std::uint8_t channel;

        [[nodiscard]] static constexpr std::size_t    wire_size() noexcept { return 2; }
        [[nodiscard]] static constexpr message_length length(bytes) noexcept { return message_length::exactly(2); }
        [[nodiscard]] static constexpr error   check(bytes pdu) noexcept { return check_fixed(pdu, code, 2); }
        [[nodiscard]] static constexpr request read(bytes pdu) noexcept { return {pdu[1]}; }
        constexpr void                         write(mutable_bytes out) const noexcept
        {
            u8_at<0>::store(out, to_byte(code));
            u8_at<1>::store(out, channel);
        }
        [[nodiscard]] constexpr error matches(response const& given) const noexcept
        {
            return expect_equal(given.channel == channel, 1);
        }
    };
};

using small = function_set<read_holding_registers, write_single_register>;
using mine  = public_functions::with<read_trace>;

constexpr auto trace_request  = "41 07"_hex;
constexpr auto trace_response = "41 07 03 0A 0B 0C"_hex;

TEST(function_set, takes_a_user_s_own_function)
{
    VERIFY(function<read_trace>);
    VERIFY(mine::name(trace_request) == "read_trace"sv);
    VERIFY(mine::name(trace_response) == "read_trace"sv);
    VERIFY(mine::name("C1 02"_hex) == "read_trace"sv);
    VERIFY(mine::request_length(trace_request) == message_length::exactly(2));
    VERIFY(mine::response_length("41 07"_hex) == message_length::at_least(3));
    VERIFY(mine::response_length(trace_response) == message_length::exactly(6));
    VERIFY(public_functions::name(trace_request) == nullptr);
}

TEST(function_set, calls_a_visitor_for_a_user_s_own_function)
{
    constexpr overload visitor{[](read_trace::request const& asked) { return int{asked.channel}; },
                               [](read_trace::response const& given) { return static_cast<int>(given.samples.size()); },
                               [](auto const&) { return -1; }};
    VERIFY(*mine::visit_request<int>(trace_request, visitor) == 7);
    VERIFY(*mine::visit_response<int>(trace_response, visitor) == 3);
    VERIFY(*mine::visit_request<int>(vectors::read_coils_request, visitor) == -1);
    VERIFY(mine::visit_request<int>("41"_hex, visitor).error() == error{errc::truncated, 2});
    VERIFY(public_functions::visit_request<int>(trace_request, visitor).error()
           == error{errc::unsupported_function, 0});
}

TEST(function_set, treats_a_user_s_own_function_like_every_message)
{
    for (unsigned byte = 0; byte <= 0xFF; ++byte) {
        std::array<std::uint8_t, 6> given = trace_response;
        given[2]                          = static_cast<std::uint8_t>(byte);
        EXPECT_TRUE(properties::consistent(properties::type_of<read_trace::response>(), given));
        EXPECT_TRUE(properties::consistent(properties::type_of<read_trace::request>(), bytes{given}.first(byte % 7)));
    }
}

//=== names ===//

TEST(function_set, names_requests_responses_and_exceptions)
{
    VERIFY(small::name("03"_hex) == "read_holding_registers"sv);
    VERIFY(small::name("83 02"_hex) == "read_holding_registers"sv);
    VERIFY(small::name("06 00"_hex) == "write_single_register"sv);
    VERIFY(small::name("04"_hex) == nullptr);
    VERIFY(small::name({}) == nullptr);
}

TEST(function_set, tells_functions_that_share_a_code_apart)
{
    VERIFY(public_functions::name("2B 0D"_hex) == "canopen_general_reference"sv);
    VERIFY(public_functions::name("2B 0E"_hex) == "read_device_identification"sv);
    VERIFY(public_functions::name("AB 0E 02"_hex) == "read_device_identification"sv);
    VERIFY(public_functions::name("2B 0F"_hex) == nullptr);
    VERIFY(public_functions::name("2B"_hex) == nullptr);
}

//=== lengths ===//

TEST(function_set, predicts_lengths)
{
    VERIFY(small::request_length("03"_hex) == message_length::exactly(5));
    VERIFY(small::response_length("03"_hex) == message_length::at_least(2));
    VERIFY(small::response_length("03 06"_hex) == message_length::exactly(8));
    VERIFY(small::request_length({}) == message_length::at_least(1));
    VERIFY(small::response_length({}) == message_length::at_least(1));
}

TEST(function_set, ends_what_it_does_not_know_with_silence)
{
    VERIFY(small::request_length("04"_hex).is_until_silence());
    VERIFY(small::response_length("04"_hex).is_until_silence());
    VERIFY(public_functions::request_length("2B 0F"_hex).is_until_silence());
    VERIFY(public_functions::request_length("00"_hex).is_until_silence());
}

TEST(function_set, waits_for_the_type_of_function_43)
{
    VERIFY(public_functions::request_length("2B"_hex) == message_length::at_least(2));
    VERIFY(public_functions::response_length("2B"_hex) == message_length::at_least(2));
    VERIFY(public_functions::request_length("2B 0E"_hex) == message_length::exactly(4));
    VERIFY(public_functions::response_length("2B 0E"_hex) == message_length::at_least(7));
    VERIFY(public_functions::request_length("2B 0D"_hex).is_until_silence());
}

TEST(function_set, knows_that_exceptions_are_responses)
{
    for (unsigned code = 0x80; code <= 0xFF; ++code) {
        std::array<std::uint8_t, 1> const pdu{static_cast<std::uint8_t>(code)};
        EXPECT_TRUE(public_functions::request_length(pdu).is_impossible());
        EXPECT_EQ(public_functions::response_length(pdu), message_length::exactly(2));
    }
}

//=== dispatch ===//

TEST(function_set, calls_the_visitor_with_the_request)
{
    constexpr overload visitor{[](read_holding_registers::request const& asked) { return int{asked.range.count()}; },
                               [](write_single_register::request const& asked) { return int{asked.value} + 1000; }};
    VERIFY(*small::visit_request<int>(vectors::read_holding_registers_request, visitor) == 3);
    VERIFY(*small::visit_request<int>(vectors::write_single_register, visitor) == 1003);
    VERIFY(small::visit_request<int>(vectors::read_coils_request, visitor).error()
           == error{errc::unsupported_function, 0});
    VERIFY(small::visit_request<int>({}, visitor).error() == error{errc::truncated, 1});
}

TEST(function_set, calls_the_visitor_with_the_response)
{
    constexpr overload visitor{
        [](read_holding_registers::response const& given) { return int{given.values[0]}; },
        [](exception_response const& given) { return -static_cast<int>(given.code); },
    };
    VERIFY(*small::visit_response<int>(vectors::read_holding_registers_response, visitor) == 0x022B);
    VERIFY(*small::visit_response<int>("83 04"_hex, visitor) == -4);
    VERIFY(*small::visit_response<int>("84 04"_hex, visitor) == -4);
    VERIFY(small::visit_response<int>("83"_hex, visitor).error() == error{errc::truncated, 2});
    VERIFY(small::visit_response<int>("06 00 01 00 03"_hex, visitor).error() == error{errc::unsupported_function, 0});
    VERIFY(small::visit_response<int>({}, visitor).error() == error{errc::truncated, 1});
}

TEST(function_set, gives_the_error_of_the_message)
{
    constexpr auto nothing = [](auto const&) { return 0; };
    VERIFY(small::visit_request<int>("03 00 00 00 7E"_hex, nothing).error() == error{errc::bad_quantity, 3});
    VERIFY(small::visit_request<int>("03 00 00 00"_hex, nothing).error() == error{errc::truncated, 5});
    VERIFY(small::visit_response<int>("03 00"_hex, nothing).error().code() == errc::truncated
           or small::visit_response<int>("03 00"_hex, nothing).error() == error{errc::bad_quantity, 1});
}

TEST(function_set, does_not_take_an_exception_for_a_request)
{
    constexpr auto nothing = [](auto const&) { return 0; };
    VERIFY(small::visit_request<int>("83 00 00 00 01"_hex, nothing).error() == error{errc::unsupported_function, 0});
}

TEST(function_set, finds_the_function)
{
    constexpr auto code_of = [](bytes pdu) {
        auto found = function_code{};
        small::find(pdu, [&found]<typename F>(std::type_identity<F>) { found = F::code; });
        return found;
    };
    VERIFY(code_of("03"_hex) == function_code::read_holding_registers);
    VERIFY(code_of("06"_hex) == function_code::write_single_register);
    VERIFY(code_of("04"_hex) == function_code{});
}

TEST(function_set, dispatches_every_printed_request_and_response_to_its_type)
{
    constexpr auto name = [](auto const& message) -> char const* {
        using T = std::remove_cvref_t<decltype(message)>;
        if constexpr (std::is_same_v<T, exception_response>) {
            return "read_coils";
        } else {
            return T::function::name;
        }
    };
    for (auto const& [expected, pdu] : vectors::printed_requests) {
        auto const visited = public_functions::visit_request<char const*>(pdu, name);
        ASSERT_TRUE(visited) << expected;
        EXPECT_STREQ(*visited, expected);
    }
    for (auto const& [expected, pdu] : vectors::printed_responses) {
        auto const visited = public_functions::visit_response<char const*>(pdu, name);
        ASSERT_TRUE(visited) << expected;
        EXPECT_STREQ(*visited, expected);
    }
}

TEST(function_set, expects_no_reply_to_force_listen_only_mode)
{
    VERIFY(not public_functions::expects_reply("08 00 04 00 00"_hex));
    VERIFY(public_functions::expects_reply("08 00 00 00 00"_hex));
    VERIFY(public_functions::expects_reply("08"_hex));
    VERIFY(public_functions::expects_reply("03 00 00 00 01"_hex));
    VERIFY(small::expects_reply("08 00 04 00 00"_hex));  // not served: exception 01
}

// One-byte PDUs of every function.
TEST(function_set, refuses_every_request_of_one_byte_that_needs_more)
{
    constexpr auto nothing = [](auto const&) { return 0; };
    for (unsigned code = 0; code <= 0xFF; ++code) {
        std::array<std::uint8_t, 1> const pdu{static_cast<std::uint8_t>(code)};
        auto const is_bare = code == 0x07 or code == 0x0B or code == 0x0C or code == 0x11;
        EXPECT_EQ(public_functions::visit_request<int>(pdu, nothing).has_value(), is_bare) << code;
        EXPECT_FALSE(public_functions::visit_response<int>(pdu, nothing)) << code;
    }
}

}  // namespace
