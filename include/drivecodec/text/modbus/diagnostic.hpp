// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/functions/diagnostics.hpp>

#include <string_view>

namespace drivecodec::modbus {

/// Empty for a sub-function that the specification does not name.
[[nodiscard]] constexpr std::string_view to_string(diagnostic sub_function) noexcept
{
    switch (sub_function) {
    case diagnostic::return_query_data: return "return_query_data";
    case diagnostic::restart_communications_option: return "restart_communications_option";
    case diagnostic::return_diagnostic_register: return "return_diagnostic_register";
    case diagnostic::change_ascii_input_delimiter: return "change_ascii_input_delimiter";
    case diagnostic::force_listen_only_mode: return "force_listen_only_mode";
    case diagnostic::clear_counters_and_diagnostic_register: return "clear_counters_and_diagnostic_register";
    case diagnostic::return_bus_message_count: return "return_bus_message_count";
    case diagnostic::return_bus_communication_error_count: return "return_bus_communication_error_count";
    case diagnostic::return_bus_exception_error_count: return "return_bus_exception_error_count";
    case diagnostic::return_server_message_count: return "return_server_message_count";
    case diagnostic::return_server_no_response_count: return "return_server_no_response_count";
    case diagnostic::return_server_nak_count: return "return_server_nak_count";
    case diagnostic::return_server_busy_count: return "return_server_busy_count";
    case diagnostic::return_bus_character_overrun_count: return "return_bus_character_overrun_count";
    case diagnostic::clear_overrun_counter_and_flag: return "clear_overrun_counter_and_flag";
    }
    return {};
}

}  // namespace drivecodec::modbus
