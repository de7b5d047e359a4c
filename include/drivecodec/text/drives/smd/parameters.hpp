// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/map.hpp>
#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/text/drives/code.hpp>
#include <drivecodec/text/drives/register_row.hpp>
#include <drivecodec/text/drives/smd/choices.hpp>
#include <drivecodec/text/drives/smd/status_block.hpp>
#include <drivecodec/text/drives/smd/words.hpp>

namespace drivecodec::smd {

/// A register and the 16 bits in it, as a log sees them; which parameter that is, the version says.
struct register_value {
    smd::version  version;
    std::uint16_t address;
    std::uint16_t raw;
};

namespace detail {

/// As the type of its own that a register has says it; false if it is none of these.
template <auto... Registers>
[[nodiscard]] constexpr bool write_one_of(text_writer& out, drives::register_row const& row, std::uint16_t raw) noexcept
{
    return ((row.name == Registers.row.name and (drives::write_meaning(out, Registers.value(raw)), true)) or ...);
}

/// Of the table alone, or of what has words of its own; which are the same in both versions.
constexpr void write_value(text_writer& out, drives::register_row const& row, std::uint16_t raw) noexcept
{
    if (row.address == drive_control.address()) { return write_text(out, decode_command(raw)); }
    if (write_one_of<drive_family, drive_hardware, load_and_operational_status, actual_direction_and_control_mode,
                     speed_source_and_speed_reference, present_fault_and_commanded_direction, C01<pv507>, C02<pv507>,
                     CE1<pv507>, CE2<pv507>, CE3<pv507>, C08<pv507>, C14<pv507>, C18<pv507>, C31<pv507>, C34<pv507>,
                     C90<pv507>, c11<pv507>, c17<pv507>, c25<pv507>, c42<pv507>, c60<pv507>, c61<pv507>, c62<pv507>,
                     c63<pv507>, c70<pv507>, d38<pv507>, n20<pv507>, n22<pv507>>(out, row, raw)) {
        return;
    }
    drives::write_value(out, row, raw);
}

}  // namespace detail

/// `C12 acceleration_time`; of a register without a code its name: `serial_speed_command`.
constexpr void write_title(text_writer& out, drives::register_row const& row) noexcept
{
    if (not row.code.empty()) { out.put(row.code).put(' '); }
    out.put(row.name);
}

/// `C12 acceleration_time 5.0 s`, `C14 operating_mode linear_with_constant_boost`, `drive_control 0008 start`; of a
/// register that the version does not have, `register 56: 1388`.
constexpr void write_text(text_writer& out, register_value given) noexcept
{
    auto const* row = map{given.version}.find(given.address);
    if (row == nullptr) { return drives::write_unknown_register(out, given.address, given.raw); }
    write_title(out, *row);
    detail::write_value(out.put(' '), *row, given.raw);
}

/// `"SMD 1.51"`; what cannot be printed in hexadecimal.
constexpr void write_text(text_writer& out, software_version const& version) noexcept
{
    std::array<std::uint8_t, std::tuple_size_v<decltype(version.characters)>> characters{};
    for (std::size_t i = 0; i < characters.size(); ++i) {
        characters[i] = static_cast<std::uint8_t>(version.characters[i]);
    }
    out.quoted(characters);
}

}  // namespace drivecodec::smd
