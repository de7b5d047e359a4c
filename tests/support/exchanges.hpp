#pragma once

#include "support/pdu_vectors.hpp"

#include <drivecodec/modbus/functions.hpp>

/// A request and its response for every public function: the specification's examples, where it prints one.
namespace exchanges {

namespace modbus = drivecodec::modbus;
using drivecodec::bytes;

template <typename Function>
struct exchange {
    using function = Function;

    bytes request;
    bytes response;
};

inline constexpr auto report_server_id_request           = "11"_hex;
inline constexpr auto report_server_id_response          = "11 04 41 42 FF 07"_hex;
inline constexpr auto canopen_general_reference_request  = "2B 0D 01 02 03"_hex;
inline constexpr auto canopen_general_reference_response = "2B 0D 04 05"_hex;

/// Calls `visit(exchange<F>)` for every F.
template <typename Visit>
constexpr void for_each(Visit visit)
{
    visit(exchange<modbus::read_coils>{vectors::read_coils_request, vectors::read_coils_response});
    visit(exchange<modbus::read_discrete_inputs>{vectors::read_discrete_inputs_request,
                                                 vectors::read_discrete_inputs_response});
    visit(exchange<modbus::read_holding_registers>{vectors::read_holding_registers_request,
                                                   vectors::read_holding_registers_response});
    visit(exchange<modbus::read_input_registers>{vectors::read_input_registers_request,
                                                 vectors::read_input_registers_response});
    visit(exchange<modbus::write_single_coil>{vectors::write_single_coil, vectors::write_single_coil});
    visit(exchange<modbus::write_single_register>{vectors::write_single_register, vectors::write_single_register});
    visit(exchange<modbus::read_exception_status>{vectors::read_exception_status_request,
                                                  vectors::read_exception_status_response});
    visit(exchange<modbus::diagnostics>{vectors::diagnostics, vectors::diagnostics});
    visit(exchange<modbus::get_comm_event_counter>{vectors::get_comm_event_counter_request,
                                                   vectors::get_comm_event_counter_response});
    visit(exchange<modbus::get_comm_event_log>{vectors::get_comm_event_log_request, vectors::get_comm_event_log_response});
    visit(exchange<modbus::write_multiple_coils>{vectors::write_multiple_coils_request,
                                                 vectors::write_multiple_coils_response});
    visit(exchange<modbus::write_multiple_registers>{vectors::write_multiple_registers_request,
                                                     vectors::write_multiple_registers_response});
    visit(exchange<modbus::report_server_id>{report_server_id_request, report_server_id_response});
    visit(exchange<modbus::read_file_record>{vectors::read_file_record_request, vectors::read_file_record_response});
    visit(exchange<modbus::write_file_record>{vectors::write_file_record, vectors::write_file_record});
    visit(exchange<modbus::mask_write_register>{vectors::mask_write_register, vectors::mask_write_register});
    visit(exchange<modbus::read_write_multiple_registers>{vectors::read_write_multiple_registers_request,
                                                          vectors::read_write_multiple_registers_response});
    visit(exchange<modbus::read_fifo_queue>{vectors::read_fifo_queue_request, vectors::read_fifo_queue_response});
    visit(exchange<modbus::canopen_general_reference>{canopen_general_reference_request,
                                                      canopen_general_reference_response});
    visit(exchange<modbus::read_device_identification>{vectors::read_device_identification_request,
                                                       vectors::read_device_identification_response});
}

}  // namespace exchanges
