// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/quantity.hpp>
#include <drivecodec/drives/access.hpp>

#include <concepts>
#include <span>
#include <type_traits>

// Between what a register or parameter means and the number that is transferred: the same for all drives.

namespace drivecodec::drives {

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
void this_register_or_parameter_is_read_only();
void this_register_or_parameter_is_write_only();
void this_register_or_parameter_is_set_at_the_panel_and_not_over_the_bus();
void the_value_has_more_digits_than_the_register_or_parameter_can_hold();
void the_value_is_none_of_those_that_the_register_or_parameter_takes();
void the_value_is_outside_the_limits_of_the_register_or_parameter();
template <int Min, int Max, int Exponent>
void the_value_must_be_between_min_and_max_times_ten_to_the_exponent();
}  // namespace compile_error

//=== what a value can be: a quantity, an integer, an enumeration, or a word of bits ===//

template <typename Value>
concept is_quantity = requires(Value given) { given.scaled_to(0); };
template <typename Value>
concept is_word = requires(Value given) { given.raw; };

/// The number that is transferred for a value, in steps of 10^`exponent` units if it is a quantity. Errors, at 0:
/// `inexact`, `out_of_range`.
template <typename Value>
[[nodiscard]] constexpr result<std::int32_t> number_of(Value wanted, int exponent) noexcept
{
    if constexpr (is_quantity<Value>) {
        return wanted.scaled_to(exponent);
    } else if constexpr (is_word<Value>) {
        return static_cast<std::int32_t>(wanted.raw);
    } else {
        return static_cast<std::int32_t>(wanted);
    }
}

/// The other way. Every number means something: unknown codes and bits survive. Precondition: an enumeration, an
/// integer or a word can hold it.
template <typename Value>
[[nodiscard]] constexpr Value value_of(std::int32_t number, std::int8_t exponent) noexcept
{
    if constexpr (is_quantity<Value>) {
        return {number, exponent};
    } else if constexpr (is_word<Value>) {
        return Value::from_raw(static_cast<typename Value::raw_type>(number));
    } else {
        return static_cast<Value>(number);
    }
}

/// Says that a register or parameter has a type of its own, where the table alone would give it another.
template <typename Value>
using value_is = std::type_identity<Value>;

/// Is the number one of these codes?
template <typename Number>
[[nodiscard]] constexpr bool is_one_of(std::span<std::uint16_t const> codes, Number wanted) noexcept
{
    auto is_one = false;
    for (auto const code : codes) { is_one = is_one or Number{code} == wanted; }
    return is_one;
}

//=== why a constant is refused, in the compiler's text ===//

template <access May>
consteval void require_writable()
{
    if constexpr (May == access::panel_only) {
        compile_error::this_register_or_parameter_is_set_at_the_panel_and_not_over_the_bus();
    } else if constexpr (not is_writable(May)) {
        compile_error::this_register_or_parameter_is_read_only();
    }
}

template <access May>
consteval void require_readable()
{
    if constexpr (not is_readable(May)) { compile_error::this_register_or_parameter_is_write_only(); }
}

}  // namespace drivecodec::drives
