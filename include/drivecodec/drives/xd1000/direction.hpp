// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::xd1000 {

/// Of rotation: bit 11 of CMD asks for it, bit 15 of ETA tells it.
enum class direction : std::uint8_t { forward = 0, reverse = 1 };

}  // namespace drivecodec::xd1000
