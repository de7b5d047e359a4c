// SPDX-License-Identifier: MIT
#pragma once

// The smd drive in words: `to_string` for every enum, `describe` for its status, parameters and words.

#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/smd/controller.hpp>
#include <drivecodec/text/drives/smd/fault.hpp>
#include <drivecodec/text/drives/smd/parameters.hpp>
#include <drivecodec/text/drives/smd/status_block.hpp>
#include <drivecodec/text/drives/smd/words.hpp>
