// SPDX-License-Identifier: MIT
#pragma once

// Everything but texts, which are in <drivecodec/text/...>.

#include <drivecodec/modbus.hpp>
#include <drivecodec/version.hpp>
