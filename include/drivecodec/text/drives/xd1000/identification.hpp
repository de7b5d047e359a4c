// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/xd1000/identification.hpp>
#include <drivecodec/text/writer.hpp>

namespace drivecodec::xd1000 {

/// `2.1`
constexpr void write_text(text_writer& out, version number) noexcept
{
    out.decimal(number.major).put('.').decimal(number.minor);
}

/// `"Lauritz Knudsen Electrical & Automation" "xD1000H037N4" 2.1`; a revision that is none stays as received.
constexpr void write_text(text_writer& out, identification const& drive) noexcept
{
    out.quoted(drive.vendor_name).put(' ').quoted(drive.product_code).put(' ');
    if (auto const number = drive.version()) {
        write_text(out, *number);
    } else {
        out.quoted(drive.major_minor_revision);
    }
}

}  // namespace drivecodec::xd1000
