// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/address.hpp>
#include <drivecodec/text/writer.hpp>

namespace drivecodec::fc {

/// `slave 22`, in either format: a slave answers to both. `broadcast`; what no slave has is `reserved address 40`, and
/// with bit 6 of the short format, which means nothing, `slave 22 (ADR 56)`.
constexpr void write_text(text_writer& out, address of) noexcept
{
    if (of.is_broadcast()) {
        out.put("broadcast");
    } else if (of.is_reserved()) {
        out.put("reserved address ").hex(of.byte());
    } else {
        out.put("slave ").decimal(of.number());
        if (of.format() == address_format::short_1_to_31 and of.byte() != of.number()) {
            out.put(" (ADR ").hex(of.byte()).put(')');
        }
    }
}

}  // namespace drivecodec::fc
