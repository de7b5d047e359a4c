// SPDX-License-Identifier: MIT
#pragma once

// CiA 402 in words: `to_string` for every enum, `describe` for both words, the state diagram.

#include <drivecodec/text/cia402/describe.hpp>
#include <drivecodec/text/cia402/names.hpp>
#include <drivecodec/text/cia402/option_code.hpp>
#include <drivecodec/text/cia402/state_diagram.hpp>
