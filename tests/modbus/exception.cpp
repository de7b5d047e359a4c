#include <drivecodec/modbus/exception.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

// MODBUS Application Protocol V1.1b3, 7.
TEST(exception_code, has_the_number_of_the_specification)
{
    constexpr auto number = [](exception_code code) { return static_cast<int>(code); };
    VERIFY(number(exception_code::illegal_function) == 1);
    VERIFY(number(exception_code::illegal_data_address) == 2);
    VERIFY(number(exception_code::illegal_data_value) == 3);
    VERIFY(number(exception_code::server_device_failure) == 4);
    VERIFY(number(exception_code::acknowledge) == 5);
    VERIFY(number(exception_code::server_device_busy) == 6);
    VERIFY(number(exception_code::memory_parity_error) == 8);
    VERIFY(number(exception_code::gateway_path_unavailable) == 10);
    VERIFY(number(exception_code::gateway_target_device_failed_to_respond) == 11);
}

TEST(exception_response, is_the_one_the_specification_prints)
{
    constexpr exception_response printed{function_code::read_coils, exception_code::illegal_data_address};
    VERIFY(encode(printed) == vectors::exception_response);
    VERIFY(*decode<exception_response>(vectors::exception_response) == printed);
}

TEST(exception_response, survives_for_every_function_and_every_code)
{
    for (unsigned function = 0; function <= 0x7F; ++function) {
        for (unsigned code = 0; code <= 0xFF; ++code) {
            auto const made = exception_response{static_cast<function_code>(function), static_cast<exception_code>(code)};
            auto const wire = encode(made);
            ASSERT_EQ(wire[0], function + 0x80);
            ASSERT_EQ(wire[1], code);
            auto const again = decode<exception_response>(wire);
            ASSERT_TRUE(again and *again == made);
        }
    }
}

TEST(exception_response, has_the_exception_bit)
{
    VERIFY(exception_response::is_exception("81"_hex));
    VERIFY(not exception_response::is_exception("01 02"_hex));
    VERIFY(not exception_response::is_exception({}));
    VERIFY(exception_response::check("01 02"_hex) == error{errc::unexpected_function, 0});
    VERIFY(exception_response::check("01"_hex) == error{errc::unexpected_function, 0});
}

TEST(exception_response, has_two_bytes)
{
    VERIFY(exception_response::check({}) == error{errc::truncated, 2});
    VERIFY(exception_response::check("81"_hex) == error{errc::truncated, 2});
    VERIFY(exception_response::check("81 02 00"_hex) == error{errc::trailing_bytes, 2});
    VERIFY(exception_response::check("AB"_hex) == error{errc::truncated, 2});
}

// Schneider ATV71 guide: the refusal of function 43 repeats the MEI type.
TEST(exception_response, of_function_43_may_have_three)
{
    constexpr exception_response refused{function_code::encapsulated_interface_transport,
                                         exception_code::illegal_data_address};
    VERIFY(*decode<exception_response>("AB 0E 02"_hex) == refused);
    VERIFY(*decode<exception_response>("AB 02"_hex) == refused);
    VERIFY(encode(refused) == "AB 02"_hex);
    VERIFY(exception_response::check("AB 0E 02 00"_hex) == error{errc::trailing_bytes, 2});
    VERIFY(exception_response::check("AA 0E 02"_hex) == error{errc::trailing_bytes, 2});
}

TEST(to_exception, tells_a_client_what_it_did_wrong)
{
    constexpr auto of = [](errc code) { return to_exception({code, 1}); };
    VERIFY(of(errc::unsupported_function) == exception_code::illegal_function);
    VERIFY(of(errc::unexpected_function) == exception_code::illegal_function);
    VERIFY(of(errc::bad_address) == exception_code::illegal_data_address);
    VERIFY(of(errc::bad_quantity) == exception_code::illegal_data_value);
    VERIFY(of(errc::bad_value) == exception_code::illegal_data_value);
    VERIFY(of(errc::bad_length) == exception_code::illegal_data_value);
    VERIFY(of(errc::truncated) == exception_code::illegal_data_value);
    VERIFY(of(errc::trailing_bytes) == exception_code::illegal_data_value);
}

}  // namespace
