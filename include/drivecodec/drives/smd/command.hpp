// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

#include <array>
#include <bit>

// Register 1, the drive control word. smd manual, section 5.2 and note 1.

namespace drivecodec::smd {

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
void only_one_command_can_be_sent_at_a_time();
}  // namespace compile_error

/// What a write to register 1 tells the drive: a momentary command, not a word that is held. One bit each, and one at a
/// time; bits 4, 5 and 10 to 15 are none.
enum class command : std::uint16_t {
    update_buffers         = 0x0001,  ///< Lets the drive start with the data that was downloaded.
    lock                   = 0x0002,  ///< Ends serial control, the watchdog and all write access.
    stop                   = 0x0004,  ///< Coast to stop.
    start                  = 0x0008,
    set_reverse            = 0x0040,
    set_forward            = 0x0080,  ///< As the drive powers up.
    serial_speed_reference = 0x0100,  ///< The speed is that of register 40. Section 7.2 calls it "manual mode".
    local_speed_reference  = 0x0200,
};
inline constexpr std::array<std::uint16_t, 8> command_codes{0x0001, 0x0002, 0x0004, 0x0008,
                                                            0x0040, 0x0080, 0x0100, 0x0200};

/// Why a word is not one command, and what the drive makes of it.
enum class command_fault : std::uint8_t {
    no_command,         ///< No bit is set. What the drive does is not stated.
    unused_bit,         ///< One bit, but none of a command. What the drive does is not stated.
    several_with_stop,  ///< Several bits with stop among them: the drive stops, and does nothing else.
    several,            ///< Several bits without stop: the drive does nothing, and answers exception 04.
};

/// A word of register 1 that is not one command: all its bits, also those without a name.
struct not_one_command {
    std::uint16_t raw;
    command_fault why;

    friend constexpr bool operator==(not_one_command, not_one_command) noexcept = default;
};

/// The command that this word is: of one bit exactly.
[[nodiscard]] constexpr result<command, not_one_command> decode_command(std::uint16_t raw) noexcept
{
    constexpr auto stop = static_cast<std::uint16_t>(command::stop);
    if (raw == 0) { return not_one_command{raw, command_fault::no_command}; }
    if (not std::has_single_bit(raw)) {
        return not_one_command{raw, (raw & stop) != 0 ? command_fault::several_with_stop : command_fault::several};
    }
    for (auto const code : command_codes) {
        if (raw == code) { return command{raw}; }
    }
    return not_one_command{raw, command_fault::unused_bit};
}

/// The command that the drive carries out when this word is written: the only one, or stop among several.
[[nodiscard]] constexpr result<command, not_one_command> executed_command(std::uint16_t raw) noexcept
{
    auto const only = decode_command(raw);
    return not only and only.error().why == command_fault::several_with_stop ? command::stop : only;
}

/// The word of a command: a constant, so that two bits are refused by the compiler.
[[nodiscard]] consteval std::uint16_t control_word(command only)
{
    auto const raw = static_cast<std::uint16_t>(only);
    if (not decode_command(raw)) { compile_error::only_one_command_can_be_sent_at_a_time(); }
    return raw;
}

}  // namespace drivecodec::smd
