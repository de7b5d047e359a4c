// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::drives {

/// Of rotation, for a drive whose speeds have no sign.
enum class direction : std::uint8_t { forward = 0, reverse = 1 };

}  // namespace drivecodec::drives
