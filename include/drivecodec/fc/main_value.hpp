// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/quantity.hpp>
#include <drivecodec/core/rounding.hpp>

#include <concepts>

namespace drivecodec::fc {

namespace compile_error {
// Declared, never defined, not constexpr: calling it is how a consteval function says no. Its name is the text.
void the_main_value_must_be_between_minus_and_plus_199_994_percent();
}  // namespace compile_error

/// What PCD2 is: of a master, of a slave.
enum class main_value : std::uint8_t { reference, output_frequency };

/// PCD2: a signed number of which 4000h is 100 %; negative is the other direction. VLT 6000 manual, "Serial
/// communication reference" and "Present output frequency".
///
/// 0 to 100 % of a reference are parameters 204 to 205, of an output frequency 201 to 202: the caller gives them. The
/// ends are +-32767, which is 199.994 %; the manual prints "+-200 %". What lies between two numbers becomes the nearest,
/// in the middle the one away from zero.
template <main_value Kind>
class basic_main_value {
public:
    static constexpr std::int32_t hundred_percent = 0x4000;
    static constexpr std::int32_t last            = 0x7FFF;

    /// 0 %.
    constexpr basic_main_value() noexcept = default;

    /// A constant; beyond the ends it does not compile.
    consteval basic_main_value(quantity<unit::percent> wanted)
    {
        auto const given = make(wanted);
        if (not given) { compile_error::the_main_value_must_be_between_minus_and_plus_199_994_percent(); }
        raw_ = given->raw();
    }

    [[nodiscard]] static constexpr basic_main_value from_raw(std::uint16_t raw) noexcept
    {
        basic_main_value made{};
        made.raw_ = raw;
        return made;
    }

    /// Errors: `out_of_range` at 0 beyond the ends.
    [[nodiscard]] static constexpr result<basic_main_value> make(quantity<unit::percent> wanted) noexcept
    {
        constexpr int most_digits = 16;  // with more digits behind the point, 32 bits hold only what rounds to 0
        if (wanted.exponent < -most_digits) { return basic_main_value{}; }
        auto const whole = wanted.exponent > 0 ? wanted.scaled_to(0) : result<std::int32_t>{wanted.number};
        if (not whole) { return whole.error(); }
        auto const parts = 100 * power_of_ten(wanted.exponent < 0 ? -wanted.exponent : 0);
        return of_number(divide_to_nearest(std::int64_t{*whole} * hundred_percent, parts));
    }

    /// Of a frequency, where `at_0_percent` and `at_100_percent` are the drive's limits: its magnitude between them, its
    /// sign the direction. Errors, at 0: `out_of_range` beyond the ends, below the lower limit, for limits that are not
    /// ascending from 0 on, for the lower limit itself in reverse if it is not 0: there is no negative zero; and where
    /// 32 bits do not hold all three with the digits of the finest.
    [[nodiscard]] static constexpr result<basic_main_value> make(quantity<unit::hertz> wanted,
                                                                 quantity<unit::hertz> at_0_percent,
                                                                 quantity<unit::hertz> at_100_percent) noexcept
    {
        auto const finest = finest_of(wanted, at_0_percent, at_100_percent);
        auto const given  = wanted.scaled_to(finest);
        auto const scale  = scale_of(at_0_percent, at_100_percent, finest);
        if (not given or not scale) { return error{errc::out_of_range, 0}; }

        auto const is_reverse = *given < 0;
        auto const above      = (is_reverse ? -std::int64_t{*given} : std::int64_t{*given}) - scale->lower;
        auto const number     = above < 0 ? -1 : divide_to_nearest(above * hundred_percent, scale->span);
        if (number < 0 or (is_reverse and number == 0 and scale->lower != 0)) { return error{errc::out_of_range, 0}; }
        return of_number(is_reverse ? -number : number);
    }

    [[nodiscard]] constexpr std::uint16_t raw() const noexcept { return raw_; }
    [[nodiscard]] constexpr std::int16_t  number() const noexcept { return static_cast<std::int16_t>(raw_); }

    /// In steps of 10^`exponent` percent, the nearest: thousandths tell all numbers apart. Errors: `out_of_range` at 0
    /// for 8000h, which is no value. Precondition: -7 <= exponent <= 0.
    [[nodiscard]] constexpr result<quantity<unit::percent>> percent(int exponent = -3) const noexcept
    {
        if (number() < -last) { return error{errc::out_of_range, 0}; }
        auto const steps = std::int64_t{number()} * 100 * power_of_ten(-exponent);
        return quantity<unit::percent>{static_cast<std::int32_t>(divide_to_nearest(steps, hundred_percent)),
                                       static_cast<std::int8_t>(exponent)};
    }

    /// In steps of 10^`exponent` Hz, the nearest; limits as for `make`. Errors, at 0: `out_of_range` for 8000h, for
    /// limits that are not ascending from 0 on, and for what 32 bits do not hold; `inexact` for limits with more digits.
    [[nodiscard]] constexpr result<quantity<unit::hertz>> frequency(quantity<unit::hertz> at_0_percent,
                                                                    quantity<unit::hertz> at_100_percent,
                                                                    int                   exponent = -3) const noexcept
    {
        auto const scale = scale_of(at_0_percent, at_100_percent, exponent);
        if (not scale) { return scale.error(); }
        if (number() < -last) { return error{errc::out_of_range, 0}; }
        auto const share     = std::int64_t{number() < 0 ? -number() : number()} * scale->span;
        auto const magnitude = scale->lower + divide_to_nearest(share, hundred_percent);
        if (magnitude > 0x7FFFFFFF) { return error{errc::out_of_range, 0}; }
        return quantity<unit::hertz>{static_cast<std::int32_t>(number() < 0 ? -magnitude : magnitude),
                                     static_cast<std::int8_t>(exponent)};
    }

    friend constexpr bool operator==(basic_main_value, basic_main_value) noexcept = default;

private:
    struct limits {
        std::int64_t lower;
        std::int64_t span;
    };

    /// The finest exponent of those that are not 0, which has the digits of any.
    template <std::same_as<quantity<unit::hertz>>... Frequencies>
    [[nodiscard]] static constexpr int finest_of(Frequencies... each) noexcept
    {
        int finest = std::numeric_limits<std::int8_t>::max();
        ((finest = each.number != 0 and each.exponent < finest ? each.exponent : finest), ...);
        return finest;
    }

    [[nodiscard]] static constexpr result<limits> scale_of(quantity<unit::hertz> at_0_percent,
                                                           quantity<unit::hertz> at_100_percent, int exponent) noexcept
    {
        auto const lower = at_0_percent.scaled_to(exponent);
        auto const upper = at_100_percent.scaled_to(exponent);
        if (not lower) { return lower.error(); }
        if (not upper) { return upper.error(); }
        if (*lower < 0 or *upper <= *lower) { return error{errc::out_of_range, 0}; }
        return limits{*lower, std::int64_t{*upper} - *lower};
    }

    [[nodiscard]] static constexpr result<basic_main_value> of_number(std::int64_t number) noexcept
    {
        if (number < -last or number > last) { return error{errc::out_of_range, 0}; }
        return from_raw(static_cast<std::uint16_t>(number));
    }

    std::uint16_t raw_ = 0;
};

using reference        = basic_main_value<main_value::reference>;
using output_frequency = basic_main_value<main_value::output_frequency>;

}  // namespace drivecodec::fc
