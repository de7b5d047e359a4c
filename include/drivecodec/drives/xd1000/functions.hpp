// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/function_set.hpp>
#include <drivecodec/modbus/functions/read_device_identification.hpp>
#include <drivecodec/modbus/functions/read_registers.hpp>
#include <drivecodec/modbus/functions/read_write_multiple_registers.hpp>
#include <drivecodec/modbus/functions/write_multiple_registers.hpp>
#include <drivecodec/modbus/functions/write_single_register.hpp>

namespace drivecodec::xd1000 {

// With the drive's limits. xD1000 manual, "Supported Modbus functions"; what it calls "Max PDU length" are numbers of
// words.
using read_holding_registers        = modbus::basic_read_holding_registers<63>;
using write_single_register         = modbus::write_single_register;
using write_multiple_registers      = modbus::basic_write_multiple_registers<61>;
using read_write_multiple_registers = modbus::basic_read_write_multiple_registers<4, 4>;
using read_device_identification    = modbus::read_device_identification;

/// All that the drive serves.
using functions = modbus::function_set<read_holding_registers, write_single_register, write_multiple_registers,
                                       read_write_multiple_registers, read_device_identification>;

}  // namespace drivecodec::xd1000
