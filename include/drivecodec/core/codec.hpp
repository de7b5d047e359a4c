// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>
#include <drivecodec/core/result.hpp>

#include <array>
#include <concepts>

namespace drivecodec {

/// A value with a wire form. Three members, each with one duty, none of which knows about buffers that are too
/// small or results that failed; `encode` and `decode` add that, once:
///
///   check(wire)  Is `wire` exactly one T? The protocol's rules, in wire order, and nowhere else.
///   read(wire)   The T in `wire`. Precondition: check(wire).ok().
///   write(out)   The wire form. Precondition: out has exactly the size of the wire form.
///
/// and `wire_size()`, the bytes it takes on the wire: a static member where all values take the same.
template <typename T>
concept writable = requires(T const value, mutable_bytes out) {
    { value.wire_size() } noexcept -> std::same_as<std::size_t>;
    { value.write(out) } noexcept -> std::same_as<void>;
};

template <typename T>
concept codec = writable<T> and requires(bytes wire) {
    { T::check(wire) } noexcept -> std::same_as<error>;
    { T::read(wire) } noexcept -> std::same_as<T>;
};

/// All values take the same number of bytes, known to the compiler.
template <typename T>
concept fixed_size = writable<T> and requires { typename std::integral_constant<std::size_t, T::wire_size()>; };

/// The wire form of `value`. Cannot fail.
template <fixed_size T>
[[nodiscard]] constexpr std::array<std::uint8_t, T::wire_size()> encode(T const& value) noexcept
{
    std::array<std::uint8_t, T::wire_size()> out{};
    value.write(out);
    return out;
}

/// Writes the wire form of `value` to the front of `out`; returns the part written.
///
/// Errors: `no_space`, and then `out` is untouched.
template <writable T>
[[nodiscard]] constexpr result<mutable_bytes> encode(T const& value, mutable_bytes out) noexcept
{
    auto const size = value.wire_size();
    if (out.size() < size) { return error{errc::no_space, size}; }
    value.write(out.first(size));
    return out.first(size);
}

/// The `T` that `wire` holds: all of `wire`, and nothing but `wire`.
///
/// Views inside the value point into `wire`. Errors: those of `T::check`.
template <codec T>
[[nodiscard]] constexpr result<T> decode(bytes wire) noexcept
{
    if (auto const fault = T::check(wire); not fault.ok()) { return fault; }
    return T::read(wire);
}

/// Refused: a value that borrows its bytes would outlive them. Name the buffer first.
template <codec T, owning_temporary Temporary>
    requires(not fixed_size<T>)
result<T> decode(Temporary&&) = delete;

}  // namespace drivecodec
