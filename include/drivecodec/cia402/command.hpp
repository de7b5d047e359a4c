// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/control_word.hpp>
#include <drivecodec/cia402/state.hpp>

#include <array>

namespace drivecodec::cia402 {

/// The commands of the controlword. IEC 61800-7-201, "Controlword", "Command coding".
enum class command : std::uint8_t {
    shutdown,
    switch_on,
    enable_operation,
    disable_operation,
    disable_voltage,
    quick_stop,
    fault_reset,
};
inline constexpr std::size_t command_count = 7;

/// The bits that a command sets or clears, and to what.
struct command_coding {
    std::uint16_t mask;
    std::uint16_t value;
};

/// By command. Bit 7 is 0 in all but the reset, so that every other command lowers it, ready for the next edge.
// clang-format off
inline constexpr std::array<command_coding, command_count> command_codings{{
    {0x0087, 0x0006},  // shutdown
    {0x008F, 0x0007},  // switch on
    {0x008F, 0x000F},  // enable operation
    {0x008F, 0x0007},  // disable operation
    {0x0082, 0x0000},  // disable voltage
    {0x0086, 0x0002},  // quick stop
    {0x0080, 0x0080},  // fault reset
}};
// clang-format on

/// `word` with the command's bits; all others are kept.
[[nodiscard]] constexpr control_word apply(command given, control_word word) noexcept
{
    auto const coding = command_codings[static_cast<std::size_t>(given)];
    return control_word::from_raw(static_cast<std::uint16_t>((word.raw & ~coding.mask) | coding.value));
}

}  // namespace drivecodec::cia402
