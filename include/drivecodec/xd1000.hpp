// SPDX-License-Identifier: MIT
#pragma once

// The Lauritz Knudsen xD1000 drive: registers, words, scanner, identification, link.

#include <drivecodec/drives/xd1000/identification.hpp>
#include <drivecodec/drives/xd1000/registers.hpp>
#include <drivecodec/drives/xd1000/scanner.hpp>
