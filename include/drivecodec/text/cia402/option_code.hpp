// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/option_code.hpp>

#include <string_view>

// An enumerator's own name; empty for a value without one.

namespace drivecodec::cia402 {

[[nodiscard]] constexpr std::string_view to_string(quick_stop_option code) noexcept
{
    switch (code) {
    case quick_stop_option::disable_drive: return "disable_drive";
    case quick_stop_option::slow_down_ramp: return "slow_down_ramp";
    case quick_stop_option::quick_stop_ramp: return "quick_stop_ramp";
    case quick_stop_option::current_limit: return "current_limit";
    case quick_stop_option::voltage_limit: return "voltage_limit";
    case quick_stop_option::slow_down_ramp_and_stay: return "slow_down_ramp_and_stay";
    case quick_stop_option::quick_stop_ramp_and_stay: return "quick_stop_ramp_and_stay";
    case quick_stop_option::current_limit_and_stay: return "current_limit_and_stay";
    case quick_stop_option::voltage_limit_and_stay: return "voltage_limit_and_stay";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(shutdown_option code) noexcept
{
    switch (code) {
    case shutdown_option::disable_drive: return "disable_drive";
    case shutdown_option::slow_down_ramp: return "slow_down_ramp";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(disable_operation_option code) noexcept
{
    switch (code) {
    case disable_operation_option::disable_drive: return "disable_drive";
    case disable_operation_option::slow_down_ramp: return "slow_down_ramp";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(halt_option code) noexcept
{
    switch (code) {
    case halt_option::slow_down_ramp: return "slow_down_ramp";
    case halt_option::quick_stop_ramp: return "quick_stop_ramp";
    case halt_option::current_limit: return "current_limit";
    case halt_option::voltage_limit: return "voltage_limit";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(fault_reaction_option code) noexcept
{
    switch (code) {
    case fault_reaction_option::disable_drive: return "disable_drive";
    case fault_reaction_option::slow_down_ramp: return "slow_down_ramp";
    case fault_reaction_option::quick_stop_ramp: return "quick_stop_ramp";
    case fault_reaction_option::current_limit: return "current_limit";
    case fault_reaction_option::voltage_limit: return "voltage_limit";
    }
    return {};
}

}  // namespace drivecodec::cia402
