// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/direction.hpp>

#include <string_view>

namespace drivecodec::drives {

/// The enumerator's own name; empty for a value without one.
[[nodiscard]] constexpr std::string_view to_string(direction which) noexcept
{
    switch (which) {
    case direction::forward: return "forward";
    case direction::reverse: return "reverse";
    }
    return {};
}

}  // namespace drivecodec::drives
