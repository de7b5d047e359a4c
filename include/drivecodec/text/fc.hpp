// SPDX-License-Identifier: MIT
#pragma once

// The FC protocol in words: `to_string` for every enum, `explain` for error numbers, `describe` for telegrams.

#include <drivecodec/text/core.hpp>
#include <drivecodec/text/fc/address.hpp>
#include <drivecodec/text/fc/describe.hpp>
#include <drivecodec/text/fc/main_value.hpp>
#include <drivecodec/text/fc/names.hpp>
#include <drivecodec/text/fc/parameter_error.hpp>
#include <drivecodec/text/fc/telegram.hpp>
