// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/quantity.hpp>
#include <drivecodec/text/core.hpp>

// Quantities as people read them. What `write_text` writes of a decimal, `parse_decimal` reads, digit for digit.

namespace drivecodec {

/// A unit's symbol, in ASCII: what stands behind the number. Empty for `unit::none`, and for a value without a name.
[[nodiscard]] constexpr std::string_view to_string(unit of) noexcept
{
    switch (of) {
    case unit::none: return {};
    case unit::hertz: return "Hz";
    case unit::second: return "s";
    case unit::minute: return "min";
    case unit::hour: return "h";
    case unit::revolution_per_minute: return "rpm";
    case unit::ampere: return "A";
    case unit::volt: return "V";
    case unit::watt: return "W";
    case unit::horsepower: return "hp";
    case unit::watt_hour: return "Wh";
    case unit::percent: return "%";
    case unit::degree_celsius: return "degC";
    case unit::ohm: return "ohm";
    case unit::henry: return "H";
    case unit::newton_metre: return "Nm";
    }
    return {};
}

/// Is a thousand of it written with a k?
[[nodiscard]] constexpr bool takes_prefix(unit of) noexcept
{
    switch (of) {
    case unit::hertz:
    case unit::ampere:
    case unit::volt:
    case unit::watt:
    case unit::watt_hour:
    case unit::ohm:
    case unit::newton_metre: return true;
    case unit::none:
    case unit::second:
    case unit::minute:
    case unit::hour:
    case unit::revolution_per_minute:
    case unit::horsepower:
    case unit::percent:
    case unit::degree_celsius:
    case unit::henry: return false;
    }
    return false;
}

/// As many digits behind the point as the exponent says: `50.0`, `-0.05`, `4000`.
constexpr void write_text(text_writer& out, decimal value) noexcept
{
    char        room[10] = {};
    text_writer digits{room};
    digits.decimal(value.number < 0 ? 0 - static_cast<std::uint32_t>(value.number)
                                    : static_cast<std::uint32_t>(value.number));
    auto const fraction = static_cast<std::size_t>(value.exponent < 0 ? -value.exponent : 0);

    if (value.number < 0) { out.put('-'); }
    for (auto position = digits.needed() > fraction ? digits.needed() : fraction + 1; position > 0; --position) {
        if (position == fraction) { out.put('.'); }
        out.put(position > digits.needed() ? '0' : room[digits.needed() - position]);
    }
    for (int zeros = value.number == 0 ? 0 : value.exponent; zeros > 0; --zeros) { out.put('0'); }
}

/// Number and symbol, of a unit that need not be known to the compiler: `50.0 Hz`, `1500 rpm`, `100 %`. What is known in
/// steps of more than one is written in thousands where the unit is: {40, 2} is `4.0 kHz`, for "4000 Hz" would claim
/// digits that nobody has measured.
constexpr void write_quantity(text_writer& out, decimal value, unit of) noexcept
{
    auto const in_kilos = takes_prefix(of) and value.exponent > 0;
    if (in_kilos) { value.exponent = static_cast<std::int8_t>(value.exponent - 3); }
    write_text(out, value);
    if (of != unit::none) { out.put(in_kilos ? " k" : " ").put(to_string(of)); }
}

template <unit Unit>
constexpr void write_text(text_writer& out, quantity<Unit> of) noexcept
{
    write_quantity(out, of.value(), Unit);
}

}  // namespace drivecodec
