// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/value.hpp>
#include <drivecodec/fc/data_type.hpp>

#include <span>
#include <string_view>

namespace drivecodec::vlt6000 {

/// To a write of what is read only, expect error 1, no write access; of what is set at the control panel (LCP) alone,
/// error 130, no bus access. Read and written are the settings of the serial line itself, and what an example or a
/// sentence writes; whether what is there to be written can be read, the manual does not say.
using drives::access;

/// What the value of a parameter is.
enum class kind : std::uint8_t {
    unknown,
    number,
    choice,  ///< One of a list; transferred is the number in the manual's brackets, as [2].
    bits,
    text,
};

/// What the manual may state, or not. Not stated is `{}`.
template <typename T>
struct stated {
    T    value{};
    bool is_known = false;

    constexpr stated() noexcept = default;
    constexpr stated(T given) noexcept : value{given}, is_known{true} {}

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return is_known; }
    /// Precondition: is_known.
    [[nodiscard]] constexpr T const& operator*() const noexcept { return value; }

    friend constexpr bool operator==(stated const&, stated const&) noexcept = default;
};

/// The least and the greatest value.
struct value_limits {
    decimal min;
    decimal max;

    friend constexpr bool operator==(value_limits const&, value_limits const&) noexcept = default;
};

/// A parameter as the manual prints it: what it does not print is unknown here. Limits and the factory setting are in
/// `unit`; the number that is transferred is another one where the conversion index is not 0.
struct parameter_row {
    std::uint16_t    number;
    std::string_view name{};          ///< Empty if the manual has the number alone. Some have their group's name.
    std::string_view display_text{};  ///< In the drive's parameter window, as printed. Empty if not printed.
    vlt6000::kind    kind   = kind::unknown;
    vlt6000::access  access = access::unknown;

    //=== on the line ===//

    stated<fc::width>     width{};
    stated<fc::data_type> data_type{};
    stated<std::int8_t>   conversion_index{};  ///< Here always a power of ten: -1 makes tenths of it.
    bool                  is_array = false;    ///< Read with an index in IND, from 1 on.

    //=== the value ===//

    drivecodec::unit unit             = unit::none;  ///< `none` also where it is not stated or selected elsewhere.
    std::int8_t      unit_prefix      = 0;           ///< Of the unit as printed: 3 for kW, -3 for mA.
    std::uint16_t    unit_selected_in = 0;           ///< The parameter that the unit depends on; 0: none.

    stated<value_limits> limits{};
    stated<decimal>      factory_setting{};

    /// Of a choice: the numbers that the manual prints. If it prints only some, there are others.
    std::span<std::uint16_t const> choices{};
    bool                           has_other_choices = false;

    std::uint8_t  max_text_length = 0;  ///< Of a text that can be written, in characters.
    std::uint16_t update_interval = 0;  ///< Of a read-out, in milliseconds. 0 if not stated.

    //=== questions ===//

    /// False only if the manual says no. Of what is unknown, the drive's reply tells.
    [[nodiscard]] constexpr bool is_writable() const noexcept { return drives::is_writable(access); }

    /// What a transferred number stands for, in `unit`: 1000 in parameter 202 is 100.0 Hz.
    /// Precondition: conversion_index.is_known.
    [[nodiscard]] constexpr decimal value(std::int32_t transferred) const noexcept
    {
        return {transferred, static_cast<std::int8_t>(*conversion_index + unit_prefix)};
    }

    /// Is this, in `unit`, a value that the parameter can have; of a choice, one that it has? Errors: `out_of_range` at
    /// 0; also for every number if the value is a text.
    [[nodiscard]] constexpr error check(decimal wanted) const noexcept
    {
        auto const is_choice = choices.empty() or has_other_choices or drives::is_one_of(choices, wanted);
        auto const is_inside = not limits or (wanted >= limits.value.min and wanted <= limits.value.max);
        return kind != kind::text and is_choice and is_inside ? error{} : error{errc::out_of_range, 0};
    }

    /// May it be written? Errors: `read_only` at 0.
    [[nodiscard]] constexpr error check_write() const noexcept
    {
        return is_writable() ? error{} : error{errc::read_only, 0};
    }

    /// May this value be written, in `unit`? Errors, at 0: `read_only`; `out_of_range` as of `check`.
    [[nodiscard]] constexpr error check_write(decimal wanted) const noexcept
    {
        auto const fault = check_write();
        return fault.ok() ? check(wanted) : fault;
    }

    /// May a text of this many characters be written? Errors, at 0: `read_only`; `out_of_range` if it is too long, or
    /// the value no text.
    [[nodiscard]] constexpr error check_text(std::size_t size) const noexcept
    {
        if (not is_writable()) { return check_write(); }
        return kind == kind::text and size <= max_text_length ? error{} : error{errc::out_of_range, 0};
    }
};

}  // namespace drivecodec::vlt6000
