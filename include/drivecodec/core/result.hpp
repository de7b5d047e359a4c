// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/error.hpp>

#include <type_traits>

namespace drivecodec {

/// A `T`, or the `E` that prevented it.
///
/// The part of std::expected<T, E> that cannot throw: there is no `value()`. Limited to trivially copyable
/// types, so that a result is one too. Dereferencing a failed result is a precondition violation; in a constant
/// expression the compiler rejects it.
template <typename T, typename E = drivecodec::error>
class [[nodiscard]] result {
    // Not a `requires` clause: `make` returns result<T> while T is still incomplete.
    static_assert(std::is_trivially_copyable_v<T>, "result<T>: T must be trivially copyable");
    static_assert(std::is_trivially_copyable_v<E>, "result<T, E>: E must be trivially copyable");

public:
    using value_type = T;
    using error_type = E;

    constexpr result(T success) noexcept : value_{success}, ok_{true} {}
    constexpr result(E failure) noexcept : error_{failure}, ok_{false} {}

    [[nodiscard]] constexpr bool has_value() const noexcept { return ok_; }
    constexpr explicit operator bool() const noexcept { return ok_; }

    /// Precondition: has_value().
    [[nodiscard]] constexpr T const& operator*() const noexcept { return value_; }
    [[nodiscard]] constexpr T const* operator->() const noexcept { return &value_; }

    /// Precondition: not has_value().
    [[nodiscard]] constexpr E error() const noexcept { return error_; }

    [[nodiscard]] constexpr T value_or(T fallback) const noexcept { return ok_ ? value_ : fallback; }

    friend constexpr bool operator==(result const& lhs, result const& rhs) noexcept
        requires requires(T const& t, E const& e) { t == t and e == e; }
    {
        if (lhs.ok_ != rhs.ok_) { return false; }
        return lhs.ok_ ? lhs.value_ == rhs.value_ : lhs.error_ == rhs.error_;
    }

private:
    union {
        T value_;
        E error_;
    };
    bool ok_;
};

}  // namespace drivecodec
