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

/// The bits that a command sets or clears, and to what: all of them are in the low byte.
struct command_coding {
    std::uint8_t mask;
    std::uint8_t value;
};

/// By command. Bit 7 is 0 in all but the reset, so that every other command lowers it, ready for the next edge.
// clang-format off
inline constexpr std::array<command_coding, command_count> command_codings{{
    {0x87, 0x06},  // shutdown
    {0x8F, 0x07},  // switch on
    {0x8F, 0x0F},  // enable operation
    {0x8F, 0x07},  // disable operation
    {0x82, 0x00},  // disable voltage
    {0x86, 0x02},  // quick stop
    {0x80, 0x80},  // fault reset
}};
// clang-format on

/// The bits that commands use; the others are the caller's.
inline constexpr std::uint16_t command_bits = [] {
    unsigned bits = 0;
    for (auto const coding : command_codings) { bits |= coding.mask; }
    return static_cast<std::uint16_t>(bits);
}();

/// `word` with the command's bits; all others are kept.
[[nodiscard]] constexpr control_word apply(command given, control_word word) noexcept
{
    auto const coding = command_codings[static_cast<std::size_t>(given)];
    return control_word::from_raw(static_cast<std::uint16_t>((word.raw & ~coding.mask) | coding.value));
}

/// What `word` tells a drive in the state `present`; every word is some command. 0007h has two names: in Operation
/// enabled it disables operation, elsewhere it switches on. The reset, an edge and no level, is not looked at.
[[nodiscard]] constexpr command decode_command(control_word word, state present) noexcept
{
    constexpr auto by_level = static_cast<std::uint16_t>(~control_word::of(control_word::fault_reset).raw);

    auto found = command::shutdown;
    while (((word.raw ^ command_codings[static_cast<std::size_t>(found)].value)
            & command_codings[static_cast<std::size_t>(found)].mask & by_level)
           != 0) {
        found = static_cast<command>(static_cast<unsigned>(found) + 1);
    }
    return found == command::switch_on and present == state::operation_enabled ? command::disable_operation : found;
}

static_assert(
    [] {
        for (unsigned low_byte = 0; low_byte <= 0xFF; ++low_byte) {
            static_cast<void>(decode_command(control_word::from_raw(static_cast<std::uint16_t>(low_byte)),
                                             state::switch_on_disabled));  // not a constant if it ran past the table
        }
        return true;
    }(),
    "every word is some command");

}  // namespace drivecodec::cia402
