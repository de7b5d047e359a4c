#include <drivecodec/modbus/messages/values_response.hpp>

#include <drivecodec/modbus/coil_view.hpp>
#include <drivecodec/modbus/register_view.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

struct peek {
    static constexpr auto code = static_cast<function_code>(0x41);
};
using registers_4 = values_response<peek, register_view, 4>;
using coils_10    = values_response<peek, coil_view, 10>;

constexpr std::array<std::uint16_t, 5> words{1, 2, 3, 4, 5};
constexpr std::array<bool, 17>         states{true, true};

TEST(values_response, is_a_byte_count_and_values)
{
    VERIFY(registers_4::check("41 04 00 01 00 02"_hex).ok());
    constexpr auto made = *registers_4::make(register_view{words}.subview(0, 2));
    EXPECT_EQ(properties::wire_of(made), properties::copy_of("41 04 00 01 00 02"_hex));
}

TEST(values_response, has_the_limit_of_its_device)
{
    VERIFY(registers_4::make({}).error() == error{errc::bad_quantity, 1});
    VERIFY(registers_4::make(register_view{words}.subview(0, 4)).has_value());
    VERIFY(registers_4::make(words).error() == error{errc::bad_quantity, 1});
    VERIFY(registers_4::check("41 00"_hex) == error{errc::bad_quantity, 1});
    VERIFY(registers_4::check("41 08 00 01 00 02 00 03 00 04"_hex).ok());
    VERIFY(registers_4::check("41 0A 00 01 00 02 00 03 00 04 00 05"_hex) == error{errc::bad_quantity, 1});
}

TEST(values_response, of_registers_has_an_even_byte_count)
{
    VERIFY(registers_4::check("41 01 00"_hex) == error{errc::bad_length, 1});
    VERIFY(registers_4::check("41 03 00 01 00"_hex) == error{errc::bad_length, 1});
    VERIFY(registers_4::check("41 FF"_hex) == error{errc::bad_length, 1});
}

TEST(values_response, of_coils_has_whole_bytes)
{
    VERIFY(coils_10::check("41 01 FF"_hex).ok());
    VERIFY(coils_10::check("41 02 FF FF"_hex).ok());
    VERIFY(coils_10::check("41 03 FF FF FF"_hex) == error{errc::bad_quantity, 1});
    VERIFY(coils_10::make(coil_view{states}.first(16)).has_value());
    VERIFY(coils_10::make(states).error() == error{errc::bad_quantity, 1});
    VERIFY(coils_10::make({}).error() == error{errc::bad_quantity, 1});
}

TEST(values_response, of_an_array_has_a_known_size)
{
    constexpr values_response<peek, register_array<2>, 4> owned{.values = register_array<2>{{0x1234, 0x5678}}};
    VERIFY(encode(owned) == "41 04 12 34 56 78"_hex);
    constexpr values_response<peek, coil_array<3>, 10> bits{.values = coil_array<3>{{true, false, true}}};
    VERIFY(encode(bits) == "41 01 05"_hex);
}

TEST(values_response, compares_values)
{
    constexpr auto one = *registers_4::make(register_view{words}.subview(0, 1));
    VERIFY(one == *registers_4::make(register_view{words}.subview(0, 1)));
    VERIFY(one != *registers_4::make(register_view{words}.subview(1, 1)));
    VERIFY(one != *registers_4::make(register_view{words}.subview(0, 2)));
}

}  // namespace
