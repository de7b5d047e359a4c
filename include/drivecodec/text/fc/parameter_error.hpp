// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/parameter_error.hpp>
#include <drivecodec/text/core.hpp>

namespace drivecodec::fc {

[[nodiscard]] constexpr std::string_view to_string(parameter_error number) noexcept
{
    switch (number) {
    case parameter_error::parameter_does_not_exist: return "parameter_does_not_exist";
    case parameter_error::no_write_access: return "no_write_access";
    case parameter_error::value_exceeds_limits: return "value_exceeds_limits";
    case parameter_error::sub_index_does_not_exist: return "sub_index_does_not_exist";
    case parameter_error::not_an_array: return "not_an_array";
    case parameter_error::data_type_does_not_match: return "data_type_does_not_match";
    case parameter_error::only_reset: return "only_reset";
    case parameter_error::not_changeable: return "not_changeable";
    case parameter_error::no_description: return "no_description";
    case parameter_error::no_parameter_write_access: return "no_parameter_write_access";
    case parameter_error::no_text: return "no_text";
    case parameter_error::not_possible_in_present_mode: return "not_possible_in_present_mode";
    case parameter_error::other_error: return "other_error";
    case parameter_error::no_bus_access: return "no_bus_access";
    case parameter_error::factory_setup_selected: return "factory_setup_selected";
    case parameter_error::no_lcp_access: return "no_lcp_access";
    case parameter_error::unknown_viewer: return "unknown_viewer";
    case parameter_error::request_not_supported: return "request_not_supported";
    case parameter_error::unknown_attribute: return "unknown_attribute";
    case parameter_error::no_error: return "no_error";
    }
    return {};
}

/// What it means, as the end of a sentence: "refused: ...". Empty for a value without a name.
[[nodiscard]] constexpr std::string_view explain(parameter_error number) noexcept
{
    switch (number) {
    case parameter_error::parameter_does_not_exist: return "the parameter does not exist";
    case parameter_error::no_write_access: return "the parameter cannot be written";
    case parameter_error::value_exceeds_limits: return "the value is outside the limits of the parameter";
    case parameter_error::sub_index_does_not_exist: return "the array has no such element";
    case parameter_error::not_an_array: return "the parameter is no array, but an element was asked for";
    case parameter_error::data_type_does_not_match: return "the parameter has another data type than the command";
    case parameter_error::only_reset: return "the parameter can only be set back";
    case parameter_error::not_changeable: return "the parameter cannot be changed";
    case parameter_error::no_description: return "the parameter has no description";
    case parameter_error::no_parameter_write_access: return "who asks may not write parameters";
    case parameter_error::no_text: return "the parameter has no text";
    case parameter_error::not_possible_in_present_mode:
        return "not in the present mode of the drive, for example while the motor runs";
    case parameter_error::other_error: return "an error that the drive has no number for";
    case parameter_error::no_bus_access: return "the parameter cannot be reached over the bus";
    case parameter_error::factory_setup_selected: return "the factory setup is selected, which cannot be changed";
    case parameter_error::no_lcp_access: return "the parameter cannot be reached from the control panel";
    case parameter_error::unknown_viewer: return "the drive does not know who asks";
    case parameter_error::request_not_supported: return "the drive does not have this command";
    case parameter_error::unknown_attribute: return "the drive does not know this attribute of a parameter";
    case parameter_error::no_error: return "nothing is wrong";
    }
    return {};
}

/// `value_exceeds_limits (2)`, `error 100`
constexpr void write_text(text_writer& out, parameter_error number) noexcept
{
    auto const name = to_string(number);
    if (name.empty()) {
        out.put("error ").decimal(static_cast<std::uint16_t>(number));
    } else {
        out.put(name).put(" (").decimal(static_cast<std::uint16_t>(number)).put(')');
    }
}

/// What is wrong, and where, as of any `error`; of a refusal its number: `exception_reply value_exceeds_limits (2)`.
constexpr void write_text(text_writer& out, reply_error fault) noexcept
{
    if (fault.code() == errc::exception_reply) {
        out.put(to_string(fault.code())).put(' ');
        write_text(out, fault.number());
    } else {
        drivecodec::write_text(out, fault);
    }
}

}  // namespace drivecodec::fc
