// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>
#include <drivecodec/fc/timing.hpp>

#include <array>

// What parameters are set to, by the number that is transferred: in brackets in the manual. VLT 6000 manual, "Serial
// communication 500 - 536"; of parameters outside of that group, the manual names single choices.

namespace drivecodec::vlt6000 {

/// Parameter 500. FLN is [2]; the heading of its addresses, in parameter 501, calls it [3].
enum class protocol : std::uint16_t {
    fc_protocol       = 0,
    metasys_n2        = 1,
    landis_staefa_fln = 2,
};
inline constexpr std::array<std::uint16_t, 3> protocol_codes{0, 1, 2};

/// The addresses that parameter 501 can be set to.
struct address_limits {
    std::uint8_t min;
    std::uint8_t max;

    friend constexpr bool operator==(address_limits, address_limits) noexcept = default;
};

/// Errors: `bad_value` at 0 for an unknown code.
[[nodiscard]] constexpr result<address_limits> address_limits_of(protocol code) noexcept
{
    switch (code) {
    case protocol::fc_protocol: return address_limits{0, 126};
    case protocol::metasys_n2: return address_limits{1, 255};
    case protocol::landis_staefa_fln: return address_limits{0, 98};
    }
    return error{errc::bad_value, 0};
}

/// Parameter 502.
enum class baud_rate : std::uint16_t {
    baud_300  = 0,
    baud_600  = 1,
    baud_1200 = 2,
    baud_2400 = 3,
    baud_4800 = 4,
    baud_9600 = 5,  ///< As the drive leaves the factory.
};
inline constexpr std::array<std::uint16_t, 6> baud_rate_codes{0, 1, 2, 3, 4, 5};

/// Errors: `bad_value` at 0 for an unknown code.
[[nodiscard]] constexpr result<std::uint32_t> bits_per_second(baud_rate code) noexcept
{
    auto const number = static_cast<std::size_t>(code);
    if (number >= fc::vlt_baud_rates.size()) { return error{errc::bad_value, 0}; }
    return fc::vlt_baud_rates[number];
}

//=== of which the manual names only some ===//

/// Parameter 001.
enum class language : std::uint16_t { english = 0, danish = 1 };
inline constexpr std::array<std::uint16_t, 2> language_codes{0, 1};

/// Parameter 007. What parameters 533 and 534 are set to shows only while this is chosen.
enum class large_display_read_out : std::uint16_t { lcp_display_text = 27 };
inline constexpr std::array<std::uint16_t, 1> large_display_read_out_codes{27};

/// Parameter 415.
enum class process_unit : std::uint16_t { kilowatt = 20 };
inline constexpr std::array<std::uint16_t, 1> process_unit_codes{20};

}  // namespace drivecodec::vlt6000
