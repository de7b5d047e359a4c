// SPDX-License-Identifier: MIT
#pragma once

// The xD1000 in words: `to_string` for every enum, `describe` for CMD, ETA, registers and the identification.

#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/xd1000/identification.hpp>
#include <drivecodec/text/drives/xd1000/registers.hpp>
