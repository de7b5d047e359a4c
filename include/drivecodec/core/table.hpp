// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

namespace drivecodec {

/// Are the rows strictly ascending by `key`: sorted, and no key twice?
template <typename Row, std::size_t N, typename Key>
[[nodiscard]] consteval bool strictly_ascending(std::array<Row, N> const& rows, Key Row::*key)
{
    for (std::size_t i = 1; i < N; ++i) {
        if (not(rows[i - 1].*key < rows[i].*key)) { return false; }
    }
    return true;
}

/// The row whose `key` is `wanted`, or nullptr. Binary search; the rows must be `strictly_ascending`.
template <typename Row, std::size_t N, typename Key>
[[nodiscard]] constexpr Row const* find_row(std::array<Row, N> const& rows, Key Row::*key,
                                            std::type_identity_t<Key> wanted) noexcept
{
    std::size_t first = 0;
    std::size_t count = N;
    while (count > 0) {
        auto const  half = count / 2;
        auto const& row  = rows[first + half];
        if (row.*key == wanted) { return &row; }
        if (row.*key < wanted) {
            first += half + 1;
            count -= half + 1;
        } else {
            count = half;
        }
    }
    return nullptr;
}

}  // namespace drivecodec
