// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/exception.hpp>

#include <concepts>
#include <type_traits>

// What a server's handler says.

namespace drivecodec::modbus {

/// A handler's answer to a request that writes: it is done. The response repeats the request's fields.
struct done {
    friend constexpr bool operator==(done, done) noexcept = default;
};

namespace detail {

/// As `result`, without a union: where no exception is 0, `answer<done>` is one byte in a register.
template <typename T>
class [[nodiscard]] compact_answer {
    static_assert(std::is_trivially_copyable_v<T>, "answer<T>: T must be trivially copyable");

public:
    using value_type = T;

    constexpr compact_answer(T success) noexcept : value_{success} {}
    /// 0, which is no exception, becomes 04.
    constexpr compact_answer(exception_code refusal) noexcept
        : error_{refusal == exception_code{} ? exception_code::server_device_failure : refusal}
    {}

    [[nodiscard]] constexpr bool has_value() const noexcept { return error_ == exception_code{}; }
    constexpr explicit operator bool() const noexcept { return has_value(); }

    /// Precondition: has_value().
    [[nodiscard]] constexpr T const& operator*() const noexcept { return value_; }
    [[nodiscard]] constexpr T const* operator->() const noexcept { return &value_; }

    /// Precondition: not has_value().
    [[nodiscard]] constexpr exception_code error() const noexcept { return error_; }

private:
    [[no_unique_address]] T value_{};
    exception_code          error_{};
};

template <typename T>
struct answer_of {
    using type = result<T, exception_code>;
};
template <std::default_initializable T>
struct answer_of<T> {
    using type = compact_answer<T>;
};

}  // namespace detail

/// What a handler answers: a `T`, or why not. Used like a `result<T, exception_code>`.
template <typename T>
using answer = typename detail::answer_of<T>::type;

}  // namespace drivecodec::modbus
