// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/status_word.hpp>
#include <drivecodec/core/pattern.hpp>
#include <drivecodec/core/result.hpp>

#include <array>

namespace drivecodec::cia402 {

/// The states of the power drive system. IEC 61800-7-201, "Finite state automaton".
enum class state : std::uint8_t {
    not_ready_to_switch_on,
    switch_on_disabled,
    ready_to_switch_on,
    switched_on,
    operation_enabled,
    quick_stop_active,
    fault_reaction_active,
    fault,
};
inline constexpr std::size_t state_count = 8;

/// How a state shows in the low byte of the statusword.
struct state_coding {
    pattern_8     low_byte;
    cia402::state state;
};

/// The standard's table of codings. Quick stop (bit 5) tells apart only the three states in which the drive is ready or
/// more; voltage enabled (4) and warning (7) tell nothing.
// clang-format off
inline constexpr std::array<state_coding, state_count> state_codings{{
    {"x0xx 0000", state::not_ready_to_switch_on},
    {"x1xx 0000", state::switch_on_disabled},
    {"x01x 0001", state::ready_to_switch_on},
    {"x01x 0011", state::switched_on},
    {"x01x 0111", state::operation_enabled},
    {"x00x 0111", state::quick_stop_active},
    {"x0xx 1111", state::fault_reaction_active},
    {"x0xx 1000", state::fault},
}};
// clang-format on

static_assert(
    [] {
        for (auto const& a : state_codings) {
            for (auto const& b : state_codings) {
                if (a.state != b.state and overlap(a.low_byte, b.low_byte)) { return false; }
            }
        }
        return true;
    }(),
    "no statusword may be two states");

/// The state that a statusword reports.
///
/// Errors: `bad_value` at 0 for a word that is none, as 104 of the 128 combinations of the low seven bits are.
[[nodiscard]] constexpr result<state> decode_state(status_word status) noexcept
{
    auto const low_byte = static_cast<std::uint8_t>(status.raw);
    for (auto const& row : state_codings) {
        if (row.low_byte.matches(low_byte)) { return row.state; }
    }
    return error{errc::bad_value, 0};
}

}  // namespace drivecodec::cia402
