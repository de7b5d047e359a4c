// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/function_code.hpp>

#include <string_view>

namespace drivecodec::modbus {

/// Empty for a code that the specification does not name.
[[nodiscard]] constexpr std::string_view to_string(function_code code) noexcept
{
    switch (code) {
    case function_code::read_coils: return "read_coils";
    case function_code::read_discrete_inputs: return "read_discrete_inputs";
    case function_code::read_holding_registers: return "read_holding_registers";
    case function_code::read_input_registers: return "read_input_registers";
    case function_code::write_single_coil: return "write_single_coil";
    case function_code::write_single_register: return "write_single_register";
    case function_code::read_exception_status: return "read_exception_status";
    case function_code::diagnostics: return "diagnostics";
    case function_code::get_comm_event_counter: return "get_comm_event_counter";
    case function_code::get_comm_event_log: return "get_comm_event_log";
    case function_code::write_multiple_coils: return "write_multiple_coils";
    case function_code::write_multiple_registers: return "write_multiple_registers";
    case function_code::report_server_id: return "report_server_id";
    case function_code::read_file_record: return "read_file_record";
    case function_code::write_file_record: return "write_file_record";
    case function_code::mask_write_register: return "mask_write_register";
    case function_code::read_write_multiple_registers: return "read_write_multiple_registers";
    case function_code::read_fifo_queue: return "read_fifo_queue";
    case function_code::encapsulated_interface_transport: return "encapsulated_interface_transport";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(direction which) noexcept
{
    switch (which) {
    case direction::request: return "request";
    case direction::response: return "response";
    }
    return {};
}

}  // namespace drivecodec::modbus
