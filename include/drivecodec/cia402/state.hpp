// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/status_word.hpp>
#include <drivecodec/core/pattern.hpp>
#include <drivecodec/core/platform.hpp>
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

inline constexpr unsigned no_state = state_count;

/// By the patterns, one after the other. What decodes at run time is made of it.
[[nodiscard]] constexpr unsigned find_state(unsigned low_byte) noexcept
{
    for (auto const& row : state_codings) {
        if (row.low_byte.matches(static_cast<std::uint8_t>(low_byte))) { return static_cast<unsigned>(row.state); }
    }
    return no_state;
}

/// Fast: the state of each combination of the low seven bits.
inline constexpr auto state_of_low_bits = [] {
    std::array<std::uint8_t, 0x80> states{};
    for (unsigned low_bits = 0; low_bits < states.size(); ++low_bits) {
        states[low_bits] = static_cast<std::uint8_t>(find_state(low_bits));
    }
    return states;
}();
[[nodiscard]] constexpr unsigned find_state_fast(unsigned word) noexcept
{
    return state_of_low_bits[word % state_of_low_bits.size()];
}

/// Small: the bits that tell states apart, 6, 5 and 3 to 0, side by side; and four bits of state for each, eight in a
/// word.
[[nodiscard]] constexpr unsigned packed_index(unsigned low_bits) noexcept
{
    return (low_bits >> 1 & 0x30U) | (low_bits & 0x0FU);
}
inline constexpr auto packed_states = [] {
    std::array<std::uint32_t, 8> packed{};
    for (unsigned low_bits = 0; low_bits < 0x80; ++low_bits) {
        if ((low_bits & 0x10U) != 0) { continue; }  // voltage enabled, which is not among them
        packed[packed_index(low_bits) / 8] |= find_state(low_bits) << packed_index(low_bits) % 8 * 4;
    }
    return packed;
}();
[[nodiscard]] constexpr unsigned find_state_small(unsigned word) noexcept
{
    auto const index = packed_index(word);
    return packed_states[index / 8] >> index % 8 * 4 & 0xFU;
}

}  // namespace detail

/// The state that a statusword reports.
///
/// Errors: `bad_value` at 0 for a word that is none, as 104 of the 128 combinations of the low seven bits are.
[[nodiscard]] constexpr result<state> decode_state(status_word status) noexcept
{
    auto const found = is_host ? detail::find_state_fast(status.raw) : detail::find_state_small(status.raw);
    if (found == detail::no_state) { return error{errc::bad_value, 0}; }
    return static_cast<state>(found);
}

}  // namespace drivecodec::cia402
