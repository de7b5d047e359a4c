// SPDX-License-Identifier: MIT
#pragma once

// The Lenze / AC Tech smd drive: registers and parameters of both versions, status, locks, watchdog, controller, link.

#include <drivecodec/drives/smd/controller.hpp>
#include <drivecodec/drives/smd/link.hpp>
#include <drivecodec/drives/smd/locks.hpp>
#include <drivecodec/drives/smd/map.hpp>
#include <drivecodec/drives/smd/numbering.hpp>
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/drives/smd/watchdog.hpp>
