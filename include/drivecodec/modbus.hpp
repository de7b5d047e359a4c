// SPDX-License-Identifier: MIT
#pragma once

// Modbus RTU, both ends of the line.

#include <drivecodec/core/overload.hpp>
#include <drivecodec/modbus/client.hpp>
#include <drivecodec/modbus/functions.hpp>
#include <drivecodec/modbus/raw_pdu.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>
#include <drivecodec/modbus/rtu/client.hpp>
#include <drivecodec/modbus/rtu/reader.hpp>
#include <drivecodec/modbus/rtu/server.hpp>
#include <drivecodec/modbus/rtu/timing.hpp>
#include <drivecodec/modbus/server.hpp>
#include <drivecodec/modbus/word_order.hpp>
