// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/hardware.hpp>
#include <drivecodec/drives/smd/numbering.hpp>
#include <drivecodec/text/drives/smd/names.hpp>
#include <drivecodec/text/flags.hpp>

namespace drivecodec::smd {

/// `0050 several`: the word, and why it is not one command.
constexpr void write_text(text_writer& out, not_one_command refused) noexcept
{
    out.hex(refused.raw).put(' ').put(to_string(refused.why));
}

/// `0008 start`, `0004 stop`; of a word that is not one command as above.
constexpr void write_text(text_writer& out, result<command, not_one_command> const& decoded) noexcept
{
    if (not decoded) { return write_text(out, decoded.error()); }
    out.hex(static_cast<std::uint16_t>(*decoded)).put(' ').put(to_string(*decoded));
}

/// `0004 oem_defaults_present`; reserved bits and those that are not used come last: `+0011`.
constexpr void write_text(text_writer& out, hardware found) noexcept
{
    constexpr std::array names{
        flag_name<hardware>{hardware::oem_defaults_present, "oem_defaults_present"},
        flag_name<hardware>{hardware::user_data_compatible_only, "user_data_compatible_only"},
    };
    out.hex(found.raw);
    write_flags(out, found, names);
}

/// As the manual writes it: `#24 (Modbus Register #25)`.
constexpr void write_text(text_writer& out, register_number number) noexcept
{
    out.put('#').decimal(number.smd()).put(" (Modbus Register #").decimal(number.modbus()).put(')');
}

}  // namespace drivecodec::smd
