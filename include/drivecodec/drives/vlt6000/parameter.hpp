// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/value.hpp>
#include <drivecodec/drives/vlt6000/table.hpp>
#include <drivecodec/drives/vlt6000/transfer.hpp>
#include <drivecodec/fc/text_requests.hpp>

namespace drivecodec::vlt6000 {

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
void the_parameter_has_another_unit_or_one_that_is_to_be_said_in_its_as();
template <int Most>
void the_text_has_at_most_so_many_characters();
}  // namespace compile_error

namespace detail {

template <unit Unit>
consteval void refuse_unit()
{
    compile_error::the_parameter_has_another_unit_or_one_that_is_to_be_said_in_its_as();
}

}  // namespace detail

/// One parameter, by its number: reads and writes it as what it is.
///
/// `Value` is a quantity or an integer for numbers, else the parameter's own word or enumeration. Where the manual does
/// not state how a value is transferred, or in which unit, the user has to:
///
///     parameter<207>.as<fc::data_type::unsigned_16, 0, unit::second>.write(5_s, storage::ram, data_not_valid)
///
/// An object has no data: what the table says becomes part of the code that uses it, and the table itself does not.
template <std::uint16_t Number, typename Value, transfer How>
struct basic_parameter {
    static constexpr parameter_row row = *find(Number);

    static_assert(row.kind != kind::text, "a text is a text_parameter");

    static constexpr bool is_quantity = drives::is_quantity<Value>;

private:
    static constexpr auto stated_index = row.conversion_index ? stated<int>{*row.conversion_index} : stated<int>{};

    template <fc::data_type Type, stated<int> ConversionIndex, drivecodec::unit Unit>
    [[nodiscard]] static consteval auto said_as()
    {
        static_assert(fc::is_number(Type), "only integer_16 to unsigned_32 are transferred as a number");
        static_assert(not row.width or *row.width == fc::width_of(Type),
                      "the manual states another width of this parameter");
        static_assert(not stated_index or ConversionIndex == stated_index,
                      "the manual states another conversion index of this parameter");
        static_assert(is_power_of_ten(ConversionIndex.value),
                      "this conversion index is no power of ten: transfer the number itself, with fc::write_word");
        static_assert(row.unit == unit::none or Unit == row.unit, "the manual states another unit of this parameter");
        return basic_parameter<Number, std::conditional_t<is_quantity, quantity<Unit>, Value>,
                               transfer::as(Type, ConversionIndex)>{};
    }

public:
    using value_type = Value;
    using request    = fc::parameter_request;
    using response   = fc::parameter_response;

    /// The same, transferred so; conversion index and unit count for numbers only. What the manual states needs not be
    /// said, and cannot be said otherwise.
    template <fc::data_type Type, stated<int> ConversionIndex = stated_index, drivecodec::unit Unit = row.unit>
    static constexpr auto as = said_as<Type, ConversionIndex, Unit>();

    [[nodiscard]] static constexpr std::uint16_t number() noexcept { return Number; }

    //=== reading ===//

    [[nodiscard]] static constexpr request read(fc::process_command process) noexcept
        requires(not row.is_array)
    {
        return fc::read_value(pnu, process);
    }
    /// Of an array; the first element is 1.
    [[nodiscard]] static constexpr request read(fc::array_index_value array_index, fc::process_command process) noexcept
        requires(row.is_array)
    {
        return fc::read_value(pnu, array_index, process);
    }

    /// What a response brings. Codes and bits without a meaning survive.
    ///
    /// Errors, at 0: `bad_value` where it brings no value, or another width than that of the data type; `out_of_range`
    /// for a number that 32 bits do not hold, or whose sign nobody states, and for a choice of more than 16 bits.
    [[nodiscard]] static constexpr result<Value> value(response const& given) noexcept
    {
        if constexpr (is_quantity) {
            static_assert(How.conversion_index.is_known, "the manual does not state the conversion index: say it, "
                                                         "parameter.as<fc::data_type::..., conversion index>");
        }
        if constexpr (drives::is_word<Value>) {
            auto const bits = bits_in(given, 8 * sizeof(Value));
            if (not bits) { return bits.error(); }
            return Value::from_raw(static_cast<typename Value::raw_type>(*bits));
        } else {
            auto const found = number_in(given, How);
            if (not found) { return found.error(); }
            constexpr auto is_code = not is_quantity and not std::same_as<Value, std::int32_t>;
            if (is_code and (*found < 0 or *found > 0xFFFF)) { return error{errc::out_of_range, 0}; }
            return drives::value_of<Value>(*found, exponent);
        }
    }

    //=== writing ===//

    /// A constant that was found fit for the parameter by the compiler, which refuses all others.
    struct constant {
        std::uint32_t pwe = 0;

        /// A value in another unit.
        template <drivecodec::unit Unit>
            requires is_quantity
        consteval constant(quantity<Unit>)
        {
            detail::refuse_unit<Unit>();
        }

        consteval constant(Value wanted)
        {
            drives::require_writable<row.access>();
            if constexpr (row.is_writable()) {
                auto const given = pwe_of(wanted);
                if (not given and given.error().code() == errc::inexact) {
                    drives::compile_error::the_value_has_more_digits_than_the_register_or_parameter_can_hold();
                }
                if (not given) {
                    drives::compile_error::the_value_is_outside_the_limits_of_the_register_or_parameter();
                }
                pwe = *given;
            }
        }
    };

    [[nodiscard]] static constexpr request write(constant wanted, fc::storage where,
                                                 fc::process_command process) noexcept
    {
        return made(wanted.pwe, where, process);
    }

    /// A value known only at run time. Errors, at 0: `read_only`, `inexact`, `out_of_range`.
    [[nodiscard]] static constexpr result<request> make_write(Value wanted, fc::storage where,
                                                              fc::process_command process) noexcept
    {
        if constexpr (not row.is_writable()) {
            return row.check_write();
        } else {
            auto const given = pwe_of(wanted);
            if (not given) { return given.error(); }
            return made(*given, where, process);
        }
    }

private:
    static constexpr auto exponent = static_cast<std::int8_t>(How.conversion_index.value + row.unit_prefix);
    static constexpr auto pnu      = *fc::parameter_number::make(Number);

    /// PWE of a value. Errors, at 0: `inexact`, `out_of_range`.
    [[nodiscard]] static constexpr result<std::uint32_t> pwe_of(Value wanted) noexcept
    {
        static_assert(How.width.is_known, "the manual does not state how this parameter is transferred: say it, "
                                          "parameter.as<fc::data_type::..., conversion index>");
        if constexpr (is_quantity) {
            static_assert(How.conversion_index.is_known, "the manual does not state the conversion index: say it, "
                                                         "parameter.as<fc::data_type::..., conversion index>");
        }
        auto const number = drives::number_of(wanted, exponent);
        if (not number) { return number.error(); }
        constexpr auto digits = is_quantity ? exponent : std::int8_t{0};
        if (auto const fault = row.check({*number, digits}); not fault.ok()) { return fault; }
        return pwe_for(*number, How);
    }

    [[nodiscard]] static constexpr request made(std::uint32_t pwe, fc::storage where,
                                                fc::process_command process) noexcept
    {
        if constexpr (How.width.value == fc::width::word) {
            return fc::write_word(pnu, static_cast<std::uint16_t>(pwe), where, process);
        } else {
            return fc::write_double_word(pnu, pwe, where, process);
        }
    }
};

/// One parameter whose value is a text: 533 and 534 can be written, 621 to 631 can be read.
template <std::uint16_t Number>
struct text_parameter {
    static constexpr parameter_row row = *find(Number);

    [[nodiscard]] static constexpr std::uint16_t number() noexcept { return Number; }

    [[nodiscard]] static constexpr auto read(fc::process_command process) noexcept
    {
        return fc::read_text(pnu, process);
    }

    /// A text known to the compiler, which refuses a longer one than the parameter takes.
    template <std::size_t Size>
    [[nodiscard]] static consteval auto write(char const (&text)[Size], fc::process_command process)
    {
        drives::require_writable<row.access>();
        if (Size - 1 > row.max_text_length) {
            compile_error::the_text_has_at_most_so_many_characters<int{row.max_text_length}>();
        }
        return fc::write_text(pnu, text, process);
    }

    /// Characters known only at run time, which are borrowed. Errors, at 0: `read_only`, `out_of_range` for too many.
    [[nodiscard]] static constexpr result<fc::text_request> make_write(bytes               characters,
                                                                       fc::process_command process) noexcept
    {
        if (auto const fault = row.check_text(characters.size()); not fault.ok()) { return fault; }
        return fc::make_write_text(pnu, characters, process);
    }

private:
    static constexpr auto pnu = *fc::parameter_number::make(Number);
};

}  // namespace drivecodec::vlt6000
