// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace drivecodec {

/// Bytes as they are on the wire; never owned by the library.
using bytes         = std::span<std::uint8_t const>;
using mutable_bytes = std::span<std::uint8_t>;

//=== wire fields ===//
// A message layout is a list of these: where a field lies and how it is stored, stated once and
// used by check, read and write alike.

/// One byte at `Offset`.
template <std::size_t Offset>
struct u8_at {
    static constexpr std::size_t begin = Offset;
    static constexpr std::size_t end   = Offset + 1;

    /// Precondition: from.size() >= end.
    [[nodiscard]] static constexpr std::uint8_t load(bytes from) noexcept { return from.data()[Offset]; }

    /// Precondition: to.size() >= end.
    static constexpr void store(mutable_bytes to, std::uint8_t field) noexcept { to.data()[Offset] = field; }
};

/// Two bytes at `Offset`, most significant first.
template <std::size_t Offset>
struct be16_at {
    static constexpr std::size_t begin = Offset;
    static constexpr std::size_t end   = Offset + 2;

    /// Precondition: from.size() >= end.
    [[nodiscard]] static constexpr std::uint16_t load(bytes from) noexcept
    {
        // Not a shift and an or: from these g++ makes a load, which Cortex-M0 has to take apart again, and a swap.
        return static_cast<std::uint16_t>(256U * from.data()[Offset] + from.data()[Offset + 1]);
    }

    /// Precondition: to.size() >= end.
    static constexpr void store(mutable_bytes to, std::uint16_t field) noexcept
    {
        to.data()[Offset]     = static_cast<std::uint8_t>(field >> 8);
        to.data()[Offset + 1] = static_cast<std::uint8_t>(field);
    }
};

//=== helpers ===//

/// A count as views keep it, in 16 bits: more than any message holds stays more than any message holds.
[[nodiscard]] constexpr std::uint16_t saturate_16(std::size_t count) noexcept
{
    return static_cast<std::uint16_t>(count < 0xFFFF ? count : 0xFFFF);
}

/// Copies all of `from` to the front of `to`. Precondition: to.size() >= from.size(), no overlap.
constexpr void copy_bytes(bytes from, mutable_bytes to) noexcept
{
    auto* out = to.data();
    for (auto const byte : from) { *out++ = byte; }
}

/// Do `a` and `b` hold the same bytes?
[[nodiscard]] constexpr bool same_bytes(bytes a, bytes b) noexcept
{
    if (a.size() != b.size()) { return false; }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a.data()[i] != b.data()[i]) { return false; }
    }
    return true;
}

/// The front of `of`, no longer than `most`.
[[nodiscard]] constexpr mutable_bytes first_at_most(mutable_bytes of, std::size_t most) noexcept
{
    return of.first(of.size() < most ? of.size() : most);
}

/// A container or span of `Value` that a `View` may borrow; not a `View` itself, nor what is made of one.
template <typename Container, typename Value, typename View>
concept borrowable_by =
    not std::is_base_of_v<View, Container> and std::is_convertible_v<Container const&, std::span<Value const>>;

/// An owning container as a temporary: what borrows its bytes would outlive them.
template <typename T>
concept owning_temporary =
    not std::is_lvalue_reference_v<T> and not std::ranges::enable_borrowed_range<std::remove_cvref_t<T>>;

}  // namespace drivecodec
