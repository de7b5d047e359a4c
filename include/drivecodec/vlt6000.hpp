// SPDX-License-Identifier: MIT
#pragma once

// The Danfoss VLT 6000 HVAC: words, parameters, gating, sequences.

#include <drivecodec/drives/vlt6000/parameters.hpp>
#include <drivecodec/drives/vlt6000/sequences.hpp>
