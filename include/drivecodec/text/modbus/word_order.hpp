// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/word_order.hpp>

#include <string_view>

namespace drivecodec::modbus {

[[nodiscard]] constexpr std::string_view to_string(word_order order) noexcept
{
    switch (order) {
    case word_order::abcd: return "abcd";
    case word_order::cdab: return "cdab";
    case word_order::badc: return "badc";
    case word_order::dcba: return "dcba";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(character_order order) noexcept
{
    switch (order) {
    case character_order::high_byte_first: return "high_byte_first";
    case character_order::low_byte_first: return "low_byte_first";
    }
    return {};
}

}  // namespace drivecodec::modbus
