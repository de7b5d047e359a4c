// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/decimal.hpp>

#include <array>

namespace drivecodec {

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
void a_quantity_is_written_in_decimal_digits_with_at_most_one_point();
void a_quantity_has_at_most_the_digits_that_fit_in_32_bits();
}  // namespace compile_error

/// What a number counts. There are no prefixes: a kilohertz is 10^3 hertz.
enum class unit : std::uint8_t {
    none,
    hertz,
    second,
    revolution_per_minute,
    ampere,
    volt,
    watt,
    horsepower,
    watt_hour,
    percent,
    degree_celsius,
};

/// A decimal number of units: 50.0 Hz is {500, -1}. No floating point, nothing rounded.
///
/// One type for all exponents. Quantities of different units have nothing to do with each other.
template <unit Unit>
struct quantity : decimal {
    [[nodiscard]] constexpr quantity operator-() const noexcept { return {decimal::operator-()}; }

    friend constexpr std::strong_ordering operator<=>(quantity a, quantity b) noexcept
    {
        return static_cast<decimal const&>(a) <=> static_cast<decimal const&>(b);
    }
    friend constexpr bool operator==(quantity a, quantity b) noexcept { return (a <=> b) == 0; }
};

namespace detail {

/// The digits of a literal, exactly.
template <unit Unit, int Prefix, char... Characters>
[[nodiscard]] consteval quantity<Unit> quantity_literal()
{
    constexpr std::array text{Characters...};
    auto const           parsed = parse_decimal(text);
    if (not parsed and parsed.error().code() == errc::out_of_range) {
        compile_error::a_quantity_has_at_most_the_digits_that_fit_in_32_bits();
    }
    // A leading zero would make other C++ integers octal.
    auto const is_octal = text.size() > 1 and text[0] == '0' and text[1] != '.';
    if (not parsed or is_octal) {
        compile_error::a_quantity_is_written_in_decimal_digits_with_at_most_one_point();
    }
    return {{parsed->number, static_cast<std::int8_t>(parsed->exponent + Prefix)}};
}

}  // namespace detail

/// `50.0_Hz`, `4_kHz`, `-1500_rpm`: exact, read from their characters. `using namespace drivecodec::literals;`
namespace literals {

// clang-format off
template <char... C> consteval quantity<unit::hertz>                 operator""_Hz()      { return detail::quantity_literal<unit::hertz,                  0, C...>(); }
template <char... C> consteval quantity<unit::hertz>                 operator""_kHz()     { return detail::quantity_literal<unit::hertz,                  3, C...>(); }
template <char... C> consteval quantity<unit::second>                operator""_s()       { return detail::quantity_literal<unit::second,                 0, C...>(); }
template <char... C> consteval quantity<unit::second>                operator""_ms()      { return detail::quantity_literal<unit::second,                -3, C...>(); }
template <char... C> consteval quantity<unit::revolution_per_minute> operator""_rpm()     { return detail::quantity_literal<unit::revolution_per_minute,  0, C...>(); }
template <char... C> consteval quantity<unit::ampere>                operator""_A()       { return detail::quantity_literal<unit::ampere,                 0, C...>(); }
template <char... C> consteval quantity<unit::ampere>                operator""_mA()      { return detail::quantity_literal<unit::ampere,                -3, C...>(); }
template <char... C> consteval quantity<unit::volt>                  operator""_V()       { return detail::quantity_literal<unit::volt,                   0, C...>(); }
template <char... C> consteval quantity<unit::watt>                  operator""_W()       { return detail::quantity_literal<unit::watt,                   0, C...>(); }
template <char... C> consteval quantity<unit::watt>                  operator""_kW()      { return detail::quantity_literal<unit::watt,                   3, C...>(); }
template <char... C> consteval quantity<unit::horsepower>            operator""_hp()      { return detail::quantity_literal<unit::horsepower,             0, C...>(); }
template <char... C> consteval quantity<unit::watt_hour>             operator""_kWh()     { return detail::quantity_literal<unit::watt_hour,              3, C...>(); }
template <char... C> consteval quantity<unit::percent>               operator""_percent() { return detail::quantity_literal<unit::percent,                0, C...>(); }
template <char... C> consteval quantity<unit::degree_celsius>        operator""_degC()    { return detail::quantity_literal<unit::degree_celsius,         0, C...>(); }
// clang-format on

}  // namespace literals

}  // namespace drivecodec
