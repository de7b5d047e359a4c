// SPDX-License-Identifier: MIT
#pragma once

// The FC protocol of Danfoss VLT drives: telegrams, parameters, texts, both ends of the line.

#include <drivecodec/fc/conversion.hpp>
#include <drivecodec/fc/master.hpp>
#include <drivecodec/fc/reader.hpp>
#include <drivecodec/fc/slave.hpp>
#include <drivecodec/fc/text_requests.hpp>
#include <drivecodec/fc/timing.hpp>
