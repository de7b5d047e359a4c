// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/function_set.hpp>
#include <drivecodec/modbus/functions/canopen_general_reference.hpp>
#include <drivecodec/modbus/functions/diagnostics.hpp>
#include <drivecodec/modbus/functions/get_comm_event_counter.hpp>
#include <drivecodec/modbus/functions/get_comm_event_log.hpp>
#include <drivecodec/modbus/functions/mask_write_register.hpp>
#include <drivecodec/modbus/functions/read_bits.hpp>
#include <drivecodec/modbus/functions/read_device_identification.hpp>
#include <drivecodec/modbus/functions/read_exception_status.hpp>
#include <drivecodec/modbus/functions/read_fifo_queue.hpp>
#include <drivecodec/modbus/functions/read_file_record.hpp>
#include <drivecodec/modbus/functions/read_registers.hpp>
#include <drivecodec/modbus/functions/read_write_multiple_registers.hpp>
#include <drivecodec/modbus/functions/report_server_id.hpp>
#include <drivecodec/modbus/functions/write_file_record.hpp>
#include <drivecodec/modbus/functions/write_multiple_coils.hpp>
#include <drivecodec/modbus/functions/write_multiple_registers.hpp>
#include <drivecodec/modbus/functions/write_single_coil.hpp>
#include <drivecodec/modbus/functions/write_single_register.hpp>

namespace drivecodec::modbus {

/// Every public function of MODBUS Application Protocol V1.1b3. With one's own: `public_functions::with<my_function>`.
using public_functions =
    function_set<read_coils, read_discrete_inputs, read_holding_registers, read_input_registers, write_single_coil,
                 write_single_register, read_exception_status, diagnostics, get_comm_event_counter, get_comm_event_log,
                 write_multiple_coils, write_multiple_registers, report_server_id, read_file_record, write_file_record,
                 mask_write_register, read_write_multiple_registers, read_fifo_queue, canopen_general_reference,
                 read_device_identification>;

}  // namespace drivecodec::modbus
