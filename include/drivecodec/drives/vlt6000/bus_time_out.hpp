// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/quantity.hpp>

#include <array>

// What a drive does when its master falls silent. VLT 6000 manual, parameters 555 and 556; both act only if parameter
// 500 is FC protocol.

namespace drivecodec::vlt6000 {

/// Parameter 555, the longest time between two telegrams: its limits, and what a drive has from the factory.
///
/// The note on relays 1 and 2 calls it the period "set in parameter 556", which is the reaction.
inline constexpr quantity<unit::second> shortest_bus_time_interval{1, 0};
inline constexpr quantity<unit::second> longest_bus_time_interval{65534, 0};
inline constexpr quantity<unit::second> factory_bus_time_interval{1, 0};

/// Parameter 556: what happens when that time has passed.
enum class bus_time_interval_function : std::uint16_t {
    off           = 0,  ///< Nothing.
    freeze_output = 1,  ///< Keeps the present output frequency.
    stop          = 2,
    jogging       = 3,  ///< Goes to the frequency of 209; the manual's text has preset reference 1 (211) instead.
    max_output_frequency = 4,  ///< Goes to the frequency of 202.
    stop_and_trip        = 5,
};

inline constexpr std::array<std::uint16_t, 6> bus_time_interval_function_codes{0, 1, 2, 3, 4, 5};

/// A drive from the factory goes on as last told, without an end, when its master falls silent.
inline constexpr bus_time_interval_function factory_bus_time_interval_function = bus_time_interval_function::off;

}  // namespace drivecodec::vlt6000
