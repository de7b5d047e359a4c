// SPDX-License-Identifier: MIT
#pragma once

namespace drivecodec {

/// Several callables as one overload set: a visitor or a server's handler, written in place.
///
///     overload{[](read_coils::request const& asked) { ... }, [](write_single_coil::request const& asked) { ... }}
template <typename... Callables>
struct overload : Callables... {
    using Callables::operator()...;
};

// C++20 deduces this by itself; clang 14 does not.
template <typename... Callables>
overload(Callables...) -> overload<Callables...>;

}  // namespace drivecodec
