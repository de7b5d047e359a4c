// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/access.hpp>

#include <string_view>

namespace drivecodec::drives {

/// An enumerator's own name; empty for a value without one.
[[nodiscard]] constexpr std::string_view to_string(access may) noexcept
{
    switch (may) {
    case access::unknown: return "unknown";
    case access::read_only: return "read_only";
    case access::read_write: return "read_write";
    case access::read_write_at_standstill: return "read_write_at_standstill";
    case access::write_only: return "write_only";
    case access::panel_only: return "panel_only";
    }
    return {};
}

}  // namespace drivecodec::drives
