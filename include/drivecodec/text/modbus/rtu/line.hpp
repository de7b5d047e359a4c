// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/rtu/framing.hpp>
#include <drivecodec/modbus/rtu/timing.hpp>
#include <drivecodec/text/writer.hpp>

namespace drivecodec::modbus::rtu {

[[nodiscard]] constexpr std::string_view to_string(parity which) noexcept
{
    switch (which) {
    case parity::none: return "none";
    case parity::even: return "even";
    case parity::odd: return "odd";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(stop_bits count) noexcept
{
    switch (count) {
    case stop_bits::one: return "one";
    case stop_bits::two: return "two";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(expecting what) noexcept
{
    switch (what) {
    case expecting::either: return "either";
    case expecting::request: return "request";
    case expecting::response: return "response";
    }
    return {};
}

/// As one writes it on a drive's display: `8E1`.
constexpr void write_text(text_writer& out, character_format format) noexcept
{
    auto const letter = format.parity == parity::none ? 'N' : format.parity == parity::even ? 'E' : 'O';
    out.decimal(character_format::data_bits).put(letter).decimal(static_cast<unsigned>(format.stop_bits));
}

}  // namespace drivecodec::modbus::rtu
