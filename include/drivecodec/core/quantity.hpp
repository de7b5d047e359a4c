// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/decimal.hpp>

namespace drivecodec {

/// What is measured in, and commanded to, drives. kHz and mA are no units: the exponent holds the prefix.
enum class unit : std::uint8_t {
    none,  ///< A number alone: a factor, a count.
    hertz,
    second,
    minute,
    hour,
    revolution_per_minute,
    ampere,
    volt,
    watt,
    horsepower,
    watt_hour,
    percent,
    degree_celsius,
    ohm,
    henry,
    newton_metre,
};

/// `number` x 10^`exponent` of `Unit`: 41.2 Hz is `quantity<unit::hertz>{412, -1}`, or as a literal `41.2_Hz`.
///
/// Every such object is a quantity; one type for all exponents, another for every unit, so that hertz are neither
/// assigned to nor compared with seconds. May be a template argument.
template <unit Unit>
struct quantity {
    static constexpr unit unit_of_measure = Unit;

    std::int32_t number   = 0;
    std::int8_t  exponent = 0;

    [[nodiscard]] static constexpr quantity of(decimal value) noexcept { return {value.number, value.exponent}; }
    [[nodiscard]] constexpr decimal         value() const noexcept { return {number, exponent}; }

    /// As `decimal::scaled_to`: the count of steps of 10^`to` units.
    [[nodiscard]] constexpr result<std::int32_t> scaled_to(int to) const noexcept { return value().scaled_to(to); }

    /// Precondition: number > -2147483648.
    [[nodiscard]] friend constexpr quantity operator-(quantity q) noexcept { return of(-q.value()); }

    /// By value, as of `decimal`.
    [[nodiscard]] friend constexpr auto operator<=>(quantity a, quantity b) noexcept { return a.value() <=> b.value(); }
    [[nodiscard]] friend constexpr bool operator==(quantity a, quantity b) noexcept { return a.value() == b.value(); }
};

//=== literals ===//

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
void a_quantity_is_written_as_decimal_digits_with_at_most_one_point();
void a_quantity_is_written_without_leading_zeros_which_would_mean_octal();
void the_digits_of_a_quantity_are_at_most_2147483647_and_128_after_the_point();
}  // namespace compile_error

namespace detail {

template <unit Unit, int Prefix, char... Text>
[[nodiscard]] consteval quantity<Unit> quantity_from_literal()
{
    constexpr char text[]{Text...};
    if (sizeof text > 1 and text[0] == '0' and (detail::is_digit(text[1]) or text[1] == '\'')) {
        compile_error::a_quantity_is_written_without_leading_zeros_which_would_mean_octal();
    }
    auto const value = parse_decimal(text);
    if (not value) {
        if (value.error().code() != errc::out_of_range) {
            compile_error::a_quantity_is_written_as_decimal_digits_with_at_most_one_point();
        }
        compile_error::the_digits_of_a_quantity_are_at_most_2147483647_and_128_after_the_point();
    }
    if (value->exponent + Prefix < std::numeric_limits<std::int8_t>::min()) {
        compile_error::the_digits_of_a_quantity_are_at_most_2147483647_and_128_after_the_point();
    }
    return {value->number, static_cast<std::int8_t>(value->exponent + Prefix)};
}

// A constant, and the operators that give it constexpr: Clang 14 does not link consteval ones that templates use.
template <unit Unit, int Prefix, char... Text>
inline constexpr auto literal = quantity_from_literal<Unit, Prefix, Text...>();

}  // namespace detail

/// Quantities as they are written: `50.0_Hz`, `4_kHz`, `250_ms`, `-41.2_Hz`, `1'500_rpm`. Read character by character,
/// never through floating point; all digits are kept, also zeros at the end. Hexadecimal, octal, binary and 1e3 do not
/// compile; nor does 010, in which C++ and the reader of a manual would see different numbers.
namespace literals {
// clang-format off
template <char... Text>
constexpr auto operator""_Hz() noexcept { return detail::literal<unit::hertz, 0, Text...>; }
template <char... Text>
constexpr auto operator""_kHz() noexcept { return detail::literal<unit::hertz, 3, Text...>; }
template <char... Text>
constexpr auto operator""_s() noexcept { return detail::literal<unit::second, 0, Text...>; }
template <char... Text>
constexpr auto operator""_ms() noexcept { return detail::literal<unit::second, -3, Text...>; }
template <char... Text>
constexpr auto operator""_min() noexcept { return detail::literal<unit::minute, 0, Text...>; }
template <char... Text>
constexpr auto operator""_h() noexcept { return detail::literal<unit::hour, 0, Text...>; }
template <char... Text>
constexpr auto operator""_rpm() noexcept { return detail::literal<unit::revolution_per_minute, 0, Text...>; }
template <char... Text>
constexpr auto operator""_A() noexcept { return detail::literal<unit::ampere, 0, Text...>; }
template <char... Text>
constexpr auto operator""_mA() noexcept { return detail::literal<unit::ampere, -3, Text...>; }
template <char... Text>
constexpr auto operator""_V() noexcept { return detail::literal<unit::volt, 0, Text...>; }
template <char... Text>
constexpr auto operator""_mV() noexcept { return detail::literal<unit::volt, -3, Text...>; }
template <char... Text>
constexpr auto operator""_kV() noexcept { return detail::literal<unit::volt, 3, Text...>; }
template <char... Text>
constexpr auto operator""_W() noexcept { return detail::literal<unit::watt, 0, Text...>; }
template <char... Text>
constexpr auto operator""_kW() noexcept { return detail::literal<unit::watt, 3, Text...>; }
template <char... Text>
constexpr auto operator""_hp() noexcept { return detail::literal<unit::horsepower, 0, Text...>; }
template <char... Text>
constexpr auto operator""_Wh() noexcept { return detail::literal<unit::watt_hour, 0, Text...>; }
template <char... Text>
constexpr auto operator""_kWh() noexcept { return detail::literal<unit::watt_hour, 3, Text...>; }
template <char... Text>
constexpr auto operator""_MWh() noexcept { return detail::literal<unit::watt_hour, 6, Text...>; }
template <char... Text>
constexpr auto operator""_percent() noexcept { return detail::literal<unit::percent, 0, Text...>; }
template <char... Text>
constexpr auto operator""_degC() noexcept { return detail::literal<unit::degree_celsius, 0, Text...>; }
template <char... Text>
constexpr auto operator""_ohm() noexcept { return detail::literal<unit::ohm, 0, Text...>; }
template <char... Text>
constexpr auto operator""_mohm() noexcept { return detail::literal<unit::ohm, -3, Text...>; }
template <char... Text>
constexpr auto operator""_H() noexcept { return detail::literal<unit::henry, 0, Text...>; }
template <char... Text>
constexpr auto operator""_mH() noexcept { return detail::literal<unit::henry, -3, Text...>; }
template <char... Text>
constexpr auto operator""_Nm() noexcept { return detail::literal<unit::newton_metre, 0, Text...>; }
// clang-format on
}  // namespace literals

}  // namespace drivecodec
