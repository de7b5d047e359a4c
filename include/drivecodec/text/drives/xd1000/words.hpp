// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/xd1000/command_word.hpp>
#include <drivecodec/drives/xd1000/status_word.hpp>
#include <drivecodec/text/cia402/describe.hpp>

namespace drivecodec::xd1000 {

/// `CMD 080F enable_operation reverse`, as a drive in the state `present` understands it: 0007 has two names. Bits
/// without one come last: `+0010`.
constexpr void write_text(text_writer& out, command_word word,
                          cia402::state present = cia402::state::switch_on_disabled) noexcept
{
    constexpr std::array names{
        flag_name<command_word>{command_word::fault_reset, "fault_reset"},
        flag_name<command_word>{command_word::halt, "halt"},
    };

    out.put("CMD ").hex(word.raw).put(' ').put(to_string(decode_command(word.standard(), present)));
    if (word.get(command_word::direction) == direction::reverse) { out.put(" reverse"); }

    constexpr std::uint16_t told{0x080F};  // by the command and by the direction
    write_flags(out, command_word::from_raw(static_cast<std::uint16_t>(word.raw & ~told)), names);
}

/// `ETA 0637 operation_enabled remote reference_reached`; of a word that is no state, `ETA 0012 no_state local`.
///
/// Voltage enabled, which is always on by the manual, shows only in the number. Reserved bits come last: `+0080`.
constexpr void write_text(text_writer& out, status_word status) noexcept
{
    constexpr std::array names{
        flag_name<status_word>{status_word::reference_reached, "reference_reached"},
        flag_name<status_word>{status_word::reference_exceeded, "reference_exceeded"},
        flag_name<status_word>{status_word::stopped_by_stop_key, "stopped_by_stop_key"},
    };

    auto const found = decode_state(status);
    out.put("ETA ").hex(status.raw).put(' ').put(found ? to_string(*found) : "no_state");
    out.put(status.is_local() ? " local" : " remote");
    if (status.get(status_word::direction) == direction::reverse) { out.put(" reverse"); }

    constexpr std::uint16_t told{0x827F};  // by the state, by local or remote, by the direction; and bit 4
    write_flags(out, status_word::from_raw(static_cast<std::uint16_t>(status.raw & ~told)), names);
}

}  // namespace drivecodec::xd1000
