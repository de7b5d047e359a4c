// SPDX-License-Identifier: MIT
#pragma once

// CiA 402 / IEC 61800-7-201: words, states, commands, and both sides of the state machine.

#include <drivecodec/cia402/controller.hpp>
#include <drivecodec/cia402/machine.hpp>
#include <drivecodec/cia402/mode_of_operation.hpp>
#include <drivecodec/cia402/mode_specific.hpp>
#include <drivecodec/cia402/option_code.hpp>
#include <drivecodec/cia402/path.hpp>
