// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
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

/// The one row of which one of `keys` is `word`, or nullptr: also for an empty word, and for one that several rows have,
/// so that none of them is taken for another.
template <typename Row, std::size_t N, std::same_as<std::string_view Row::*>... Keys>
[[nodiscard]] constexpr Row const* find_word(std::array<Row, N> const& rows, std::string_view word,
                                             Keys... keys) noexcept
{
    Row const* found = nullptr;
    if (word.empty()) { return found; }
    for (auto const& row : rows) {
        if (((row.*keys != word) and ...)) { continue; }
        if (found != nullptr) { return nullptr; }
        found = &row;
    }
    return found;
}

}  // namespace drivecodec
