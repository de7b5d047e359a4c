// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/vlt6000/parameter_row.hpp>
#include <drivecodec/text/drives/access.hpp>
#include <drivecodec/text/quantity.hpp>

#include <utility>

namespace drivecodec::vlt6000 {

// An enumerator's own name; empty for a value without one.

[[nodiscard]] constexpr std::string_view to_string(kind what) noexcept
{
    switch (what) {
    case kind::unknown: return "unknown";
    case kind::number: return "number";
    case kind::choice: return "choice";
    case kind::bits: return "bits";
    case kind::text: return "text";
    }
    return {};
}

/// What the table alone says of a transferred number, PWE high and low: `100.0 Hz`, `10 s`. Bits in hexadecimal, with 8
/// digits of a double word, else 4 if they suffice. All else, as a choice or a number of which the scale is unknown, is
/// written as it is: without a unit, which would not be true of it.
constexpr void write_value(text_writer& out, parameter_row const& row, std::uint32_t transferred) noexcept
{
    if (row.kind == kind::bits) {
        if (row.width == fc::width::double_word or transferred > 0xFFFF) {
            out.hex(transferred);
        } else {
            out.hex(static_cast<std::uint16_t>(transferred));
        }
    } else if (row.conversion_index and std::in_range<std::int32_t>(transferred)) {
        write_quantity(out, row.value(static_cast<std::int32_t>(transferred)), row.unit);
    } else {
        out.decimal(transferred);
    }
}

}  // namespace drivecodec::vlt6000
