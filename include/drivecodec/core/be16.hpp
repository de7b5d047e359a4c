// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>
#include <drivecodec/core/platform.hpp>

#include <bit>
#include <cstring>

// Runs of 16-bit values: most significant byte first on the wire, std::uint16_t on the host.

namespace drivecodec {

namespace detail {

// Of blocks with a known size g++ makes vector instructions already at -O2: eight times as fast as value by value.
inline constexpr std::size_t be16_block = 8;

[[nodiscard]] constexpr std::uint16_t swap_if_little_endian(std::uint16_t word) noexcept
{
    if constexpr (std::endian::native == std::endian::big) { return word; }
    return static_cast<std::uint16_t>((word << 8) | (word >> 8));
}

/// Copies whole blocks of `count` words and swaps their bytes; returns how many words it has done.
template <typename From, typename To>
std::size_t swap_blocks(From const* from, To* to, std::size_t count) noexcept
{
    std::size_t done = 0;
    for (; done + be16_block <= count; done += be16_block) {
        std::uint16_t block[be16_block];
        std::memcpy(block, from + done * 2 / sizeof(From), sizeof block);
        for (auto& word : block) { word = swap_if_little_endian(word); }
        std::memcpy(to + done * 2 / sizeof(To), block, sizeof block);
    }
    return done;
}

}  // namespace detail

/// Reads `to.size()` values. Precondition: from.size() >= 2 * to.size().
constexpr void load_be16(bytes from, std::span<std::uint16_t> to) noexcept
{
    std::size_t done = 0;
    if constexpr (is_host) {
        if (not std::is_constant_evaluated()) { done = detail::swap_blocks(from.data(), to.data(), to.size()); }
    }
    for (; done < to.size(); ++done) { to.data()[done] = be16_at<0>::load(from.subspan(2 * done)); }
}

/// Writes `from.size()` values. Precondition: to.size() >= 2 * from.size().
constexpr void store_be16(std::span<std::uint16_t const> from, mutable_bytes to) noexcept
{
    std::size_t done = 0;
    if constexpr (is_host) {
        if (not std::is_constant_evaluated()) { done = detail::swap_blocks(from.data(), to.data(), from.size()); }
    }
    for (; done < from.size(); ++done) { be16_at<0>::store(to.subspan(2 * done), from.data()[done]); }
}

}  // namespace drivecodec
