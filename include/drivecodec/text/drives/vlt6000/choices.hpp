// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/vlt6000/choices.hpp>

#include <string_view>

// An enumerator's own name; empty for a value without one.

namespace drivecodec::vlt6000 {

[[nodiscard]] constexpr std::string_view to_string(protocol code) noexcept
{
    switch (code) {
    case protocol::fc_protocol: return "fc_protocol";
    case protocol::metasys_n2: return "metasys_n2";
    case protocol::landis_staefa_fln: return "landis_staefa_fln";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(baud_rate code) noexcept
{
    switch (code) {
    case baud_rate::baud_300: return "baud_300";
    case baud_rate::baud_600: return "baud_600";
    case baud_rate::baud_1200: return "baud_1200";
    case baud_rate::baud_2400: return "baud_2400";
    case baud_rate::baud_4800: return "baud_4800";
    case baud_rate::baud_9600: return "baud_9600";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(language code) noexcept
{
    switch (code) {
    case language::english: return "english";
    case language::danish: return "danish";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(large_display_read_out code) noexcept
{
    switch (code) {
    case large_display_read_out::lcp_display_text: return "lcp_display_text";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(process_unit code) noexcept
{
    switch (code) {
    case process_unit::kilowatt: return "kilowatt";
    }
    return {};
}

}  // namespace drivecodec::vlt6000
