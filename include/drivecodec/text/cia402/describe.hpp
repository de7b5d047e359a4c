// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/command.hpp>
#include <drivecodec/text/cia402/names.hpp>
#include <drivecodec/text/flags.hpp>

namespace drivecodec::cia402 {

/// `0637 operation_enabled voltage_enabled remote target_reached`; of a word that is no state, `0002 no_state`.
constexpr void write_text(text_writer& out, status_word status) noexcept
{
    auto const found = decode_state(status);
    out.hex(status.raw).put(' ').put(found ? to_string(*found) : "no_state");

    constexpr std::uint16_t state_bits = 0x006F;
    constexpr std::array    names{
        flag_name<status_word>{status_word::voltage_enabled, "voltage_enabled"},
        flag_name<status_word>{status_word::warning, "warning"},
        flag_name<status_word>{status_word::remote, "remote"},
        flag_name<status_word>{status_word::target_reached, "target_reached"},
        flag_name<status_word>{status_word::internal_limit_active, "internal_limit_active"},
    };
    write_flags(out, status_word::from_raw(static_cast<std::uint16_t>(status.raw & ~state_bits)), names);
}

/// `010F enable_operation halt`, as a drive in the state `present` understands it: 0007 has two names.
constexpr void write_text(text_writer& out, control_word word, state present = state::switch_on_disabled) noexcept
{
    out.hex(word.raw).put(' ').put(to_string(decode_command(word, present)));

    constexpr std::array names{
        flag_name<control_word>{control_word::fault_reset, "fault_reset"},
        flag_name<control_word>{control_word::halt, "halt"},
    };
    auto const others = static_cast<std::uint16_t>(word.raw & (0x0080U | static_cast<unsigned>(~command_bits)));
    write_flags(out, control_word::from_raw(others), names);
}

/// The same into the caller's characters; ends with "..." if it does not fit.
[[nodiscard]] constexpr std::string_view describe(status_word status, std::span<char> out) noexcept
{
    text_writer text{out};
    write_text(text, status);
    return text.view_with_ellipsis();
}
[[nodiscard]] constexpr std::string_view describe(control_word word, std::span<char> out,
                                                  state present = state::switch_on_disabled) noexcept
{
    text_writer text{out};
    write_text(text, word, present);
    return text.view_with_ellipsis();
}

}  // namespace drivecodec::cia402
