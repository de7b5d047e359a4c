// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/xd1000/link.hpp>
#include <drivecodec/text/drives/direction.hpp>

#include <string_view>

// An enumerator's own name; empty for a value without one.

namespace drivecodec::xd1000 {

[[nodiscard]] constexpr std::string_view to_string(baud_rate code) noexcept
{
    switch (code) {
    case baud_rate::baud_4800: return "baud_4800";
    case baud_rate::baud_9600: return "baud_9600";
    case baud_rate::baud_19200: return "baud_19200";
    case baud_rate::baud_38400: return "baud_38400";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(character_format code) noexcept
{
    switch (code) {
    case character_format::format_8o1: return "format_8o1";
    case character_format::format_8e1: return "format_8e1";
    case character_format::format_8n1: return "format_8n1";
    case character_format::format_8n2: return "format_8n2";
    }
    return {};
}

}  // namespace drivecodec::xd1000
