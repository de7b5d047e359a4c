// SPDX-License-Identifier: MIT
#pragma once

// Everything but texts, which are in <drivecodec/text/...>.

#include <drivecodec/cia402.hpp>
#include <drivecodec/fc.hpp>
#include <drivecodec/modbus.hpp>
#include <drivecodec/smd.hpp>
#include <drivecodec/version.hpp>
#include <drivecodec/vlt6000.hpp>
#include <drivecodec/xd1000.hpp>
