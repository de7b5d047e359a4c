// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/command.hpp>
#include <drivecodec/drives/direction.hpp>

namespace drivecodec::xd1000 {

using drives::direction;  // bit 11 of CMD asks for it, bit 15 of ETA tells it

/// CMD, register 8501: what the drive is told. xD1000 manual, "Command word description".
///
/// The controlword of CiA 402 with the drive's own halt and direction. Names say what a 1 does. Every command of the
/// manual has the example that `cia402::apply` makes of it: 0006, 0007, 000F, 0000, 0002, 0080.
struct command_word : word<command_word, std::uint16_t> {
    static constexpr flag<command_word> switch_on{0};
    /// The manual calls it "Switch on disabled, active at 0"; its command Disable voltage is this bit at 0.
    static constexpr flag<command_word> enable_voltage{1};
    static constexpr flag<command_word> no_quick_stop{2};
    static constexpr flag<command_word> enable_operation{3};
    /// The manual says "0: free wheel staying in Operation enabled", but runs the motor with 000F. So what it does is
    /// open; every example has a 0.
    static constexpr flag<command_word> bit_4{4};
    static constexpr flag<command_word> fault_reset{7};  ///< Acts when it changes from 0 to 1.
    static constexpr flag<command_word> halt{8};  ///< Stops as parameter 502.0 says; the state stays Operation enabled.
    static constexpr field<command_word, xd1000::direction, 11, 1> direction{};

    constexpr command_word() noexcept = default;
    /// The command alone, all other bits 0: forward, no halt.
    constexpr command_word(cia402::command given) noexcept : command_word{cia402::apply(given, {})} {}
    /// Bit for bit; what the standard leaves to modes and manufacturers is here what this drive makes of it.
    constexpr explicit command_word(cia402::control_word standard) noexcept { raw = standard.raw; }

    [[nodiscard]] constexpr cia402::control_word standard() const noexcept
    {
        return cia402::control_word::from_raw(raw);
    }
};

/// `word` with the command's bits; halt, direction and all others are kept.
[[nodiscard]] constexpr command_word apply(cia402::command given, command_word word) noexcept
{
    return command_word{cia402::apply(given, word.standard())};
}

}  // namespace drivecodec::xd1000
