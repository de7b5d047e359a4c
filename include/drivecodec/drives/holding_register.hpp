// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/register_row.hpp>
#include <drivecodec/drives/value.hpp>
#include <drivecodec/modbus/functions/read_registers.hpp>
#include <drivecodec/modbus/functions/write_single_register.hpp>

namespace drivecodec::drives {

/// One register of a drive, by name: reads and writes it as what it is.
///
/// `Table` is the drive's, of `register_row`; `Read` is its function 03, with its limit. `Value` is a quantity or
/// an integer for numbers, else the register's own word or enumeration, or std::uint16_t for bits without a meaning. An
/// object has no data: what the table says becomes part of the code that uses it, and the table itself does not.
template <auto const& Table, std::uint16_t Address, typename Read, typename Value, int Exponent>
struct basic_holding_register {
    static constexpr register_row row = [] {
        auto found     = *find(Table, Address);  // no constant if there is no such register
        found.exponent = Exponent;
        return found;
    }();

    using value_type = Value;
    using request    = modbus::write_single_register::request;

    static constexpr bool takes_every_value = row.is_writable() and row.type == raw_type::bits and is_word<Value>;

    [[nodiscard]] static constexpr std::uint16_t address() noexcept { return Address; }

    /// The same with another scale, where the manual's is in doubt.
    template <int Other>
    static constexpr basic_holding_register<Table, Address, Read, Value, Other> with_exponent{};

    //=== between values and the 16 bits ===//

    /// What these 16 bits mean. Every word means something: unknown codes and bits survive.
    [[nodiscard]] static constexpr Value value(std::uint16_t raw) noexcept
    {
        return value_of<Value>(row.number(raw), Exponent);
    }

    /// The 16 bits of a value. Errors, at 0: `inexact`, `out_of_range`.
    [[nodiscard]] static constexpr result<std::uint16_t> raw(Value wanted) noexcept
    {
        auto const number = number_of(wanted, Exponent);
        if (not number) { return number.error(); }
        if (auto const fault = row.check(*number); not fault.ok()) { return fault; }
        return static_cast<std::uint16_t>(*number);
    }

    //=== requests ===//

    [[nodiscard]] static consteval typename Read::request read()
    {
        require_readable<row.access>();
        return {.range = {Address, 1}};
    }

    /// A word of which the register takes every value, known when it may be.
    [[nodiscard]] static constexpr request write(Value wanted) noexcept
        requires takes_every_value
    {
        return {.address = Address, .value = wanted.raw};
    }

    /// A constant value: refused by the compiler if the register cannot take it.
    [[nodiscard]] static consteval request write(Value wanted)
        requires(not takes_every_value)
    {
        require_writable<row.access>();
        auto const bits = raw(wanted);
        if (not bits and bits.error().code() == errc::inexact) {
            compile_error::the_value_has_more_digits_than_the_register_or_parameter_can_hold();
        }
        if (not bits and not row.choices.empty()) {
            compile_error::the_value_is_none_of_those_that_the_register_or_parameter_takes();
        }
        if (not bits) {
            compile_error::the_value_must_be_between_min_and_max_times_ten_to_the_exponent<row.limits.min,
                                                                                           row.limits.max, Exponent>();
        }
        return {.address = Address, .value = *bits};
    }

    /// A value known only at run time. Errors, at 0: `read_only`; those of `raw`.
    [[nodiscard]] static constexpr result<request> make_write(Value wanted) noexcept
    {
        if (not row.is_writable()) { return error{errc::read_only, 0}; }
        auto const bits = raw(wanted);
        if (not bits) { return bits.error(); }
        return request{.address = Address, .value = *bits};
    }
};

/// What a register is that holds a number: a quantity, or an integer if it counts nothing.
template <auto const& Table, std::uint16_t Address>
using number_in = std::conditional_t<find(Table, Address)->unit == unit::none and find(Table, Address)->exponent == 0,
                                     std::int32_t, quantity<find(Table, Address)->unit>>;

/// With the scale of the table.
template <auto const& Table, std::uint16_t Address, typename Read, typename Value = number_in<Table, Address>>
using holding_register = basic_holding_register<Table, Address, Read, Value, find(Table, Address)->exponent>;

}  // namespace drivecodec::drives
