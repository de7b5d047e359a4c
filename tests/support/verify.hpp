#pragma once

#include <gtest/gtest.h>

#include <type_traits>

/// The value itself, but unknown to the optimizer: a run-time test that passes its input through `opaque` runs the
/// code, and not the compiler's knowledge of the answer.
template <typename T>
[[nodiscard]] constexpr T opaque(T value) noexcept
{
    if (not std::is_constant_evaluated()) { asm volatile("" : : "r"(&value) : "memory"); }
    return value;
}

/// Proves a constant expression twice: while compiling, and again by running the code the optimizer made of it.
#define VERIFY(...)                          \
    do {                                     \
        static_assert(__VA_ARGS__);          \
        EXPECT_TRUE(opaque((__VA_ARGS__)));  \
    } while (false)
