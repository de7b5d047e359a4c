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

namespace detail {

/// The bits that tell states apart, side by side: 6, 5 and 3 to 0.
[[nodiscard]] constexpr unsigned state_index(unsigned low_byte) noexcept
{
    return (low_byte >> 1 & 0x30U) | (low_byte & 0x0FU);
}

inline constexpr unsigned no_state = state_count;

/// The state of each index, four bits each; eight in a word. The patterns, turned into what decodes fast and small.
inline constexpr auto states_by_index = [] {
    std::array<std::uint32_t, 8> packed{};
    for (unsigned low_byte = 0; low_byte < 0x80; ++low_byte) {
        auto found = no_state;
        for (auto const& row : state_codings) {
            if (row.low_byte.matches(static_cast<std::uint8_t>(low_byte))) { found = static_cast<unsigned>(row.state); }
        }
        auto const index = state_index(low_byte);
        packed[index / 8] |= found << index % 8 * 4;
    }
    return packed;
}();

}  // namespace detail

/// The state that a statusword reports.
///
/// Errors: `bad_value` at 0 for a word that is none, as 104 of the 128 combinations of the low seven bits are.
[[nodiscard]] constexpr result<state> decode_state(status_word status) noexcept
{
    auto const index = detail::state_index(status.raw);
    auto const found = detail::states_by_index[index / 8] >> index % 8 * 4 & 0xFU;
    if (found == detail::no_state) { return error{errc::bad_value, 0}; }
    return static_cast<state>(found);
}

}  // namespace drivecodec::cia402
