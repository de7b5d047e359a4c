// SPDX-License-Identifier: MIT
#pragma once

// The VLT 6000 HVAC in words: `to_string` for every enum, `describe` for its words and parameters.

#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/vlt6000/parameters.hpp>
