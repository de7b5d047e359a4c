// SPDX-License-Identifier: MIT
#pragma once

// Modbus in words: `to_string` for every enum, `describe` for PDUs and frames, `for_each_field` for what is in them.

#include <drivecodec/text/core.hpp>
#include <drivecodec/text/modbus/comm_event.hpp>
#include <drivecodec/text/modbus/describe.hpp>
#include <drivecodec/text/modbus/device_identification.hpp>
#include <drivecodec/text/modbus/diagnostic.hpp>
#include <drivecodec/text/modbus/exception_code.hpp>
#include <drivecodec/text/modbus/fields.hpp>
#include <drivecodec/text/modbus/function_code.hpp>
#include <drivecodec/text/modbus/rtu/describe.hpp>
#include <drivecodec/text/modbus/rtu/line.hpp>
#include <drivecodec/text/modbus/word_order.hpp>
