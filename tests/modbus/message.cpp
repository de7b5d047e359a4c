#include <drivecodec/modbus/message.hpp>

#include <drivecodec/modbus/functions.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

//=== concepts ===//

template <typename... Functions>
consteval bool all_are_functions(function_set<Functions...>)
{
    return (function<Functions> and ...);
}

TEST(function, is_every_public_one)
{
    VERIFY(all_are_functions(public_functions{}));
    VERIFY(function<basic_read_holding_registers<63>> and function<basic_write_multiple_registers<4>>);
}

struct no_name : read_coils {
    static constexpr int name = 0;
};
struct no_response {
    static constexpr auto        code = function_code::read_coils;
    static constexpr char const* name = "no_response";
    using request                     = read_coils::request;
};

TEST(function, is_not_what_lacks_a_part)
{
    VERIFY(not function<no_name>);
    VERIFY(not function<no_response>);
    VERIFY(not function<int>);
}

TEST(message, is_a_request_or_a_response)
{
    VERIFY(readable_message<read_coils::request> and request_message<read_coils::request>);
    VERIFY(readable_message<read_coils::response> and not request_message<read_coils::response>);
    VERIFY(message<read_holding_registers::basic_response<register_array<2>>>);
    VERIFY(not message<exception_response>);
}

TEST(message, of_one_size_is_an_array_when_encoded)
{
    VERIFY(fixed_size<read_coils::request> and fixed_size<write_single_coil::response>);
    VERIFY(fixed_size<write_multiple_registers::basic_request<register_array<2>>>);
    VERIFY(not fixed_size<write_multiple_registers::request> and not fixed_size<read_coils::response>);
}

//=== rules that every PDU obeys ===//

constexpr auto code = function_code::read_coils;

TEST(check_head, looks_at_the_function_before_the_length)
{
    VERIFY(check_head({}, code, 2, 5) == error{errc::truncated, 5});
    VERIFY(check_head("02"_hex, code, 2, 5) == error{errc::unexpected_function, 0});
    VERIFY(check_head("81 00 00"_hex, code, 2, 5) == error{errc::unexpected_function, 0});
    VERIFY(check_head("01"_hex, code, 2, 5) == error{errc::truncated, 5});
    VERIFY(check_head("01 00"_hex, code, 2, 5).ok());
    VERIFY(check_head("01 00 00 00 00 00"_hex, code, 2, 5).ok());
}

TEST(check_size, wants_exactly_so_many)
{
    VERIFY(check_size("01 02"_hex, 3) == error{errc::truncated, 3});
    VERIFY(check_size("01 02 03"_hex, 3).ok());
    VERIFY(check_size("01 02 03 04"_hex, 3) == error{errc::trailing_bytes, 3});
    VERIFY(check_size({}, 0).ok());
}

TEST(check_fixed, wants_both)
{
    VERIFY(check_fixed("01 02"_hex, code, 2).ok());
    VERIFY(check_fixed("01"_hex, code, 2) == error{errc::truncated, 2});
    VERIFY(check_fixed("01 02 03"_hex, code, 2) == error{errc::trailing_bytes, 2});
    VERIFY(check_fixed("02 02 03"_hex, code, 2) == error{errc::unexpected_function, 0});
}

TEST(expect_equal, says_which_field_differs)
{
    VERIFY(expect_equal(true, 3).ok());
    VERIFY(expect_equal(false, 3) == error{errc::unexpected_reply, 3});
}

TEST(expects_reply, is_true_but_for_force_listen_only_mode)
{
    constexpr write_single_register::request write{.address = 1, .value = 3};
    constexpr auto                           listen = diagnostics::of(diagnostic::force_listen_only_mode);
    constexpr auto                           restart = diagnostics::of(diagnostic::restart_communications_option);
    VERIFY(expects_reply(write));
    VERIFY(expects_reply(restart));
    VERIFY(not expects_reply(listen));
}

}  // namespace
