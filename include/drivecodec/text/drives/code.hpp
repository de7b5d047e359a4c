// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/text/writer.hpp>

#include <type_traits>

namespace drivecodec::drives {

/// A code's name, as its `to_string` has it, or the number of one without a name.
template <typename Enum>
    requires std::is_enum_v<Enum>
constexpr void write_code(text_writer& out, Enum code) noexcept
{
    if (auto const name = to_string(code); name.empty()) {
        out.decimal(static_cast<std::underlying_type_t<Enum>>(code));
    } else {
        out.put(name);
    }
}

/// A value in the words of its own `write_text`, or, if it has none, as `write_code` has it.
template <typename Value>
constexpr void write_meaning(text_writer& out, Value const& value) noexcept
{
    if constexpr (requires { write_text(out, value); }) {
        write_text(out, value);
    } else {
        write_code(out, value);
    }
}

}  // namespace drivecodec::drives
