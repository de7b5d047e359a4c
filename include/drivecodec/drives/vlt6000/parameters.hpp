// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/vlt6000/alarm_word.hpp>
#include <drivecodec/drives/vlt6000/bus_time_out.hpp>
#include <drivecodec/drives/vlt6000/control_word.hpp>
#include <drivecodec/drives/vlt6000/digital_inputs.hpp>
#include <drivecodec/drives/vlt6000/extended_status_word.hpp>
#include <drivecodec/drives/vlt6000/gating.hpp>
#include <drivecodec/drives/vlt6000/parameter.hpp>
#include <drivecodec/drives/vlt6000/status_word.hpp>
#include <drivecodec/drives/vlt6000/warning_word.hpp>

// The parameters by number, as people speak of them, and by the manual's names:
//
//     fc::encode(fc::address::short_format(1), vlt6000::parameter<202>.read(fc::data_not_valid))
//     vlt6000::parameters::output_frequency_high_limit.write(100_Hz, fc::storage::ram_and_eeprom, fc::data_not_valid)

namespace drivecodec::vlt6000 {

namespace detail {

/// What the value of a parameter is: what the table says, unless it has a type of its own.
template <std::uint16_t Number>
struct value_of {
    static constexpr parameter_row row = *find(Number);

    static constexpr bool is_code    = row.kind == kind::bits or row.kind == kind::choice;
    static constexpr bool is_counted = row.kind == kind::unknown or (row.unit == unit::none and row.limits.is_known);

    using type =
        std::conditional_t<is_code, std::uint16_t, std::conditional_t<is_counted, std::int32_t, quantity<row.unit>>>;
};

using drives::value_is;

// clang-format off
template <> struct value_of<1>   : value_is<language> {};
template <> struct value_of<7>   : value_is<large_display_read_out> {};
template <> struct value_of<415> : value_is<process_unit> {};
template <> struct value_of<500> : value_is<protocol> {};
template <> struct value_of<502> : value_is<baud_rate> {};
template <> struct value_of<503> : value_is<gating> {};
template <> struct value_of<504> : value_is<gating> {};
template <> struct value_of<505> : value_is<gating> {};
template <> struct value_of<506> : value_is<gating> {};
template <> struct value_of<507> : value_is<gating> {};
template <> struct value_of<508> : value_is<gating> {};
template <> struct value_of<521> : value_is<digital_inputs> {};
template <> struct value_of<527> : value_is<status_word> {};
template <> struct value_of<529> : value_is<alarm_word> {};
template <> struct value_of<530> : value_is<control_word> {};
template <> struct value_of<531> : value_is<warning_word> {};
template <> struct value_of<532> : value_is<extended_status_word> {};
template <> struct value_of<556> : value_is<bus_time_interval_function> {};
// clang-format on

/// 0, which no parameter has, for what is no number of 16 bits: not that of another parameter.
[[nodiscard]] consteval std::uint16_t not_wrapped(int number)
{
    return number < 0 or number > 0xFFFF ? std::uint16_t{0} : static_cast<std::uint16_t>(number);
}

template <std::uint16_t Number>
[[nodiscard]] consteval auto parameter_of()
{
    static_assert(find(Number) != nullptr, "the VLT 6000 manual names no parameter of this number");
    constexpr auto const& row = *find(Number);
    if constexpr (row.kind == kind::text) {
        return text_parameter<Number>{};
    } else {
        return basic_parameter<Number, typename value_of<Number>::type, transfer::of(row)>{};
    }
}

}  // namespace detail

/// The parameter of this number, of those that the manual names.
template <int Number>
inline constexpr auto parameter = detail::parameter_of<detail::not_wrapped(Number)>();

// By name, as the table has it; in a namespace of their own, since the manual has a control word and a parameter called
// so. Names that several parameters share are left to the numbers.
namespace parameters {
// clang-format off
inline constexpr auto language                           = parameter<1>;
inline constexpr auto active_setup                       = parameter<2>;
inline constexpr auto max_value_of_user_defined_read_out = parameter<5>;
inline constexpr auto unit_for_user_defined_read_out     = parameter<6>;
inline constexpr auto large_display_read_out             = parameter<7>;
inline constexpr auto dc_braking_current                 = parameter<114>;
inline constexpr auto dc_braking_time                    = parameter<115>;
inline constexpr auto motor_thermal_protection           = parameter<117>;
inline constexpr auto output_frequency_low_limit         = parameter<201>;
inline constexpr auto output_frequency_high_limit        = parameter<202>;
inline constexpr auto minimum_reference                  = parameter<204>;
inline constexpr auto maximum_reference                  = parameter<205>;
inline constexpr auto ramp_up_time                       = parameter<206>;
inline constexpr auto ramp_down_time                     = parameter<207>;
inline constexpr auto jog_frequency                      = parameter<209>;
inline constexpr auto preset_reference_1                 = parameter<211>;
inline constexpr auto preset_reference_2                 = parameter<212>;
inline constexpr auto preset_reference_3                 = parameter<213>;
inline constexpr auto preset_reference_4                 = parameter<214>;
inline constexpr auto current_limit                      = parameter<215>;
inline constexpr auto trip_delay_overcurrent             = parameter<412>;
inline constexpr auto process_units                      = parameter<415>;
inline constexpr auto protocol                           = parameter<500>;
inline constexpr auto address                            = parameter<501>;
inline constexpr auto baudrate                           = parameter<502>;
inline constexpr auto coasting_stop                      = parameter<503>;
inline constexpr auto dc_brake                           = parameter<504>;
inline constexpr auto start                              = parameter<505>;
inline constexpr auto reversing                          = parameter<506>;
inline constexpr auto selection_of_setup                 = parameter<507>;
inline constexpr auto selection_of_preset_reference      = parameter<508>;
inline constexpr auto resulting_reference                = parameter<509>;
inline constexpr auto resulting_reference_in_unit        = parameter<510>;
inline constexpr auto feedback                           = parameter<511>;
inline constexpr auto frequency                          = parameter<512>;
inline constexpr auto user_defined_read_out              = parameter<513>;
inline constexpr auto motor_current                      = parameter<514>;
inline constexpr auto power_in_kw                        = parameter<515>;
inline constexpr auto power_in_hp                        = parameter<516>;
inline constexpr auto motor_voltage                      = parameter<517>;
inline constexpr auto dc_link_voltage                    = parameter<518>;
inline constexpr auto thermal_load_motor                 = parameter<519>;
inline constexpr auto thermal_load_vlt                   = parameter<520>;
inline constexpr auto digital_input                      = parameter<521>;
inline constexpr auto terminal_53_analog_input           = parameter<522>;
inline constexpr auto terminal_54_analog_input           = parameter<523>;
inline constexpr auto terminal_60_analog_input           = parameter<524>;
inline constexpr auto pulse_reference                    = parameter<525>;
inline constexpr auto external_reference                 = parameter<526>;
inline constexpr auto status_word                        = parameter<527>;
inline constexpr auto heat_sink_temperature              = parameter<528>;
inline constexpr auto alarm_word                         = parameter<529>;
inline constexpr auto control_word                       = parameter<530>;
inline constexpr auto warning_word                       = parameter<531>;
inline constexpr auto extended_status_word               = parameter<532>;
inline constexpr auto display_text_1                     = parameter<533>;
inline constexpr auto display_text_2                     = parameter<534>;
inline constexpr auto bus_feedback_1                     = parameter<535>;
inline constexpr auto bus_feedback_2                     = parameter<536>;
inline constexpr auto bus_time_interval                  = parameter<555>;
inline constexpr auto bus_time_interval_function         = parameter<556>;
inline constexpr auto error_code                         = parameter<615>;
inline constexpr auto unit_type                          = parameter<621>;
// clang-format on
}  // namespace parameters

}  // namespace drivecodec::vlt6000
