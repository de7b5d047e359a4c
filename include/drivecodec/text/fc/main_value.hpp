// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/main_value.hpp>
#include <drivecodec/text/quantity.hpp>

namespace drivecodec::fc {

/// `50.00 %`, to the nearest hundredth; 8000h, which is no value, as `8000`.
template <main_value Kind>
constexpr void write_text(text_writer& out, basic_main_value<Kind> value) noexcept
{
    if (auto const percent = value.percent(-2)) {
        drivecodec::write_text(out, *percent);
    } else {
        out.hex(value.raw());
    }
}

}  // namespace drivecodec::fc
