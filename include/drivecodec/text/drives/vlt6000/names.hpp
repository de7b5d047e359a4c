// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/vlt6000/bus_time_out.hpp>
#include <drivecodec/drives/vlt6000/gating.hpp>

#include <string_view>

// An enumerator's own name; empty for a value without one.

namespace drivecodec::vlt6000 {

[[nodiscard]] constexpr std::string_view to_string(preset_reference chosen) noexcept
{
    switch (chosen) {
    case preset_reference::preset_reference_1: return "preset_reference_1";
    case preset_reference::preset_reference_2: return "preset_reference_2";
    case preset_reference::preset_reference_3: return "preset_reference_3";
    case preset_reference::preset_reference_4: return "preset_reference_4";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(setup chosen) noexcept
{
    switch (chosen) {
    case setup::setup_1: return "setup_1";
    case setup::setup_2: return "setup_2";
    case setup::setup_3: return "setup_3";
    case setup::setup_4: return "setup_4";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(gating choice) noexcept
{
    switch (choice) {
    case gating::digital_input: return "digital_input";
    case gating::serial_communication: return "serial_communication";
    case gating::logic_and: return "logic_and";
    case gating::logic_or: return "logic_or";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(bus_time_interval_function choice) noexcept
{
    switch (choice) {
    case bus_time_interval_function::off: return "off";
    case bus_time_interval_function::freeze_output: return "freeze_output";
    case bus_time_interval_function::stop: return "stop";
    case bus_time_interval_function::jogging: return "jogging";
    case bus_time_interval_function::max_output_frequency: return "max_output_frequency";
    case bus_time_interval_function::stop_and_trip: return "stop_and_trip";
    }
    return {};
}

}  // namespace drivecodec::vlt6000
