// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/register_view.hpp>

#include <array>
#include <bit>
#include <concepts>

// Values of several registers. The specification knows 16-bit registers only; in which order a device lays the four
// bytes of a 32-bit value into two of them is the device's choice, and its manual's to tell.

namespace drivecodec::modbus {

/// The bytes of a 32-bit value in the order of the wire; A is the most significant.
enum class word_order : std::uint8_t {
    abcd,  ///< Big-endian: the first register is the high word.
    cdab,  ///< The first register is the low word.
    badc,  ///< The first register is the high word, its bytes swapped.
    dcba,  ///< Little-endian: the first register is the low word, its bytes swapped.
};

/// 32 bits that lie in two registers: std::uint32_t, std::int32_t, float.
template <typename T>
concept two_registers = sizeof(T) == 4 and (std::integral<T> or std::floating_point<T>);

namespace detail {

[[nodiscard]] constexpr bool low_word_first(word_order order) noexcept
{
    return order == word_order::cdab or order == word_order::dcba;
}
[[nodiscard]] constexpr std::uint16_t swap_bytes_for(word_order order, std::uint16_t word) noexcept
{
    auto const swaps = order == word_order::badc or order == word_order::dcba;
    return swaps ? static_cast<std::uint16_t>((word << 8) | (word >> 8)) : word;
}

}  // namespace detail

/// The two registers that hold `contents`.
template <two_registers T>
[[nodiscard]] constexpr std::array<std::uint16_t, 2> to_registers(T contents, word_order order) noexcept
{
    auto const bits = std::bit_cast<std::uint32_t>(contents);
    auto const high = detail::swap_bytes_for(order, static_cast<std::uint16_t>(bits >> 16));
    auto const low  = detail::swap_bytes_for(order, static_cast<std::uint16_t>(bits));
    if (detail::low_word_first(order)) { return {low, high}; }
    return {high, low};
}

/// The value in the registers `index` and `index + 1`. Precondition: index + 2 <= values.size().
template <two_registers T>
[[nodiscard]] constexpr T from_registers(register_view values, std::size_t index, word_order order) noexcept
{
    std::uint32_t const first  = detail::swap_bytes_for(order, values[index]);
    std::uint32_t const second = detail::swap_bytes_for(order, values[index + 1]);
    return std::bit_cast<T>(detail::low_word_first(order) ? second << 16 | first : first << 16 | second);
}

//=== texts ===//

/// Which character of a register comes first in a text.
enum class character_order : std::uint8_t { high_byte_first, low_byte_first };

/// Copies the text in `values`, two characters a register, up to its end or that of `to`; returns the part filled.
/// What a device pads with, zeros or blanks, is copied too.
constexpr std::span<char> copy_text(register_view values, std::span<char> to, character_order order) noexcept
{
    auto const size  = to.size() < 2 * values.size() ? to.size() : 2 * values.size();
    auto const first = order == character_order::high_byte_first ? 8U : 0U;
    for (std::size_t i = 0; i < size; ++i) {
        auto const shift = i % 2 == 0 ? first : 8U - first;
        to[i]            = static_cast<char>(static_cast<unsigned char>(values[i / 2] >> shift));
    }
    return to.first(size);
}

/// Lays `text` into `to`, two characters a register, and pads with `padding`; returns how many characters fit.
constexpr std::size_t copy_text(std::span<char const> text, std::span<std::uint16_t> to, character_order order,
                                char padding = '\0') noexcept
{
    auto const first = order == character_order::high_byte_first ? 8U : 0U;
    for (std::size_t i = 0; i < to.size(); ++i) {
        unsigned const early = static_cast<unsigned char>(2 * i < text.size() ? text[2 * i] : padding);
        unsigned const late  = static_cast<unsigned char>(2 * i + 1 < text.size() ? text[2 * i + 1] : padding);
        to[i]                = static_cast<std::uint16_t>(early << first | late << (8U - first));
    }
    return text.size() < 2 * to.size() ? text.size() : 2 * to.size();
}

}  // namespace drivecodec::modbus
