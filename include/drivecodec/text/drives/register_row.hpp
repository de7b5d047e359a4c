// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/register_row.hpp>
#include <drivecodec/text/drives/access.hpp>
#include <drivecodec/text/quantity.hpp>

namespace drivecodec::drives {

// An enumerator's own name; empty for a value without one.

[[nodiscard]] constexpr std::string_view to_string(raw_type type) noexcept
{
    switch (type) {
    case raw_type::unsigned_number: return "unsigned_number";
    case raw_type::signed_number: return "signed_number";
    case raw_type::bits: return "bits";
    case raw_type::enumeration: return "enumeration";
    case raw_type::register_address: return "register_address";
    case raw_type::two_bytes: return "two_bytes";
    case raw_type::text: return "text";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(source from) noexcept
{
    switch (from) {
    case source::manual: return "manual";
    case source::sister_drive: return "sister_drive";
    case source::nobody: return "nobody";
    }
    return {};
}

/// What to call a register: its code if it has bits, as people know those by it; else its name.
[[nodiscard]] constexpr std::string_view title(register_row const& row) noexcept
{
    return row.type == raw_type::bits and not row.code.empty() ? row.code : row.name;
}

/// What the table alone says of these 16 bits: `50.0 Hz`, `13 s`, `-1500 rpm`; bits, bytes and characters in
/// hexadecimal; codes and addresses as numbers.
constexpr void write_value(text_writer& out, register_row const& row, std::uint16_t raw) noexcept
{
    if (row.type == raw_type::bits or row.type == raw_type::two_bytes or row.type == raw_type::text) {
        out.hex(raw);
    } else {
        write_quantity(out, {row.number(raw), row.exponent}, row.unit);
    }
}

/// `register 5000: 1388`, of one that no table has.
constexpr void write_unknown_register(text_writer& out, std::uint16_t address, std::uint16_t raw) noexcept
{
    out.put("register ").decimal(address).put(": ").hex(raw);
}

}  // namespace drivecodec::drives
