// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/xd1000/registers.hpp>
#include <drivecodec/text/drives/code.hpp>
#include <drivecodec/text/drives/register_row.hpp>
#include <drivecodec/text/drives/xd1000/names.hpp>
#include <drivecodec/text/drives/xd1000/words.hpp>

namespace drivecodec::xd1000 {

/// A register and the 16 bits in it, as a log sees them.
struct register_value {
    std::uint16_t address;
    std::uint16_t raw;
};

namespace detail {

/// `3201 ETA`, `3104 high_speed`, `0 unused`; of a register that the manual does not have the number alone.
constexpr void write_address(text_writer& out, std::uint16_t address) noexcept
{
    out.decimal(address);
    if (address == 0) { out.put(" unused"); }
    if (auto const* row = find(address)) { out.put(' ').put(drives::title(*row)); }
}

}  // namespace detail

/// `CMD 000F enable_operation`, `high_speed 50.0 Hz`, `baud_rate baud_19200`, `input_1_source 3201 ETA`; of a register
/// that the manual does not have, `register 5000: 1388`.
///
/// `present` is the state that a command is for, as in `write_text` of a command word.
constexpr void write_text(text_writer& out, register_value given,
                          cia402::state present = cia402::state::switch_on_disabled) noexcept
{
    if (given.address == cmd.address()) { return write_text(out, cmd.value(given.raw), present); }
    if (given.address == eta.address()) { return write_text(out, eta.value(given.raw)); }
    auto const* row = find(given.address);
    if (row == nullptr) { return drives::write_unknown_register(out, given.address, given.raw); }
    out.put(drives::title(*row)).put(' ');
    if (given.address == baud_rate_setting.address()) {
        drives::write_code(out, baud_rate_setting.value(given.raw));
    } else if (given.address == character_format_setting.address()) {
        drives::write_code(out, character_format_setting.value(given.raw));
    } else if (given.address == modbus_address.address() and given.raw == 0) {
        out.put("off");
    } else if (row->type == drives::raw_type::register_address) {
        detail::write_address(out, given.raw);
    } else {
        drives::write_value(out, *row, given.raw);
    }
}

/// The values of adjacent registers, as they are read and written.
struct register_values {
    std::uint16_t         first;
    modbus::register_view values;
};

/// `high_speed 50.0 Hz, low_speed 0.0 Hz`
constexpr void write_text(text_writer& out, register_values const& given,
                          cia402::state present = cia402::state::switch_on_disabled) noexcept
{
    for (std::size_t i = 0; i < given.values.size(); ++i) {
        if (i != 0) { out.put(", "); }
        write_text(out, register_value{static_cast<std::uint16_t>(given.first + i), given.values[i]}, present);
    }
}

}  // namespace drivecodec::xd1000
