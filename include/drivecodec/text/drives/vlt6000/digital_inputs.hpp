// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/vlt6000/digital_inputs.hpp>
#include <drivecodec/text/flags.hpp>

namespace drivecodec::vlt6000 {

/// The eight inputs as the manual shows them, 16 to the extreme left, then those with a signal: `00101000 18 27`. Bits
/// above the eight come last: `+0100`.
constexpr void write_text(text_writer& out, digital_inputs inputs) noexcept
{
    constexpr std::array<flag_name<digital_inputs>, 8> names{{
        {digital_inputs::terminal_16, "16"},
        {digital_inputs::terminal_17, "17"},
        {digital_inputs::terminal_18, "18"},
        {digital_inputs::terminal_19, "19"},
        {digital_inputs::terminal_27, "27"},
        {digital_inputs::terminal_29, "29"},
        {digital_inputs::terminal_32, "32"},
        {digital_inputs::terminal_33, "33"},
    }};
    for (auto const& input : names) { out.put(inputs.test(input.bit) ? '1' : '0'); }
    write_flags(out, inputs, names);
}

}  // namespace drivecodec::vlt6000
