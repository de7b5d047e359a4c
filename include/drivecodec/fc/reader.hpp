// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/deframer.hpp>
#include <drivecodec/fc/framing.hpp>

namespace drivecodec::fc {

/// Finds every valid telegram in a noisy line; see `deframer` for how to feed it and what comes out.
///
/// A silence is `timing::silence()`. A BCC has eight bits: of 256 runs of noise that begin like a telegram, one ends like
/// one. Slaves act on aligned telegrams only, and masters check what answers them.
template <typename Layout = vlt_layout, std::size_t Capacity = max_telegram_size + 64>
class basic_reader : public deframer<framing<Layout>, Capacity> {
    using base = deframer<framing<Layout>, Capacity>;

public:
    /// Listens to everything.
    constexpr basic_reader() noexcept = default;
    constexpr explicit basic_reader(expecting what) noexcept : base{framing<Layout>{what}} {}

    /// Of the slave with this address, on a line that it may share with others: what has its number is a request. So
    /// would be its own responses, were they to come back.
    constexpr basic_reader(expecting what, address own_address) noexcept : base{framing<Layout>{what, own_address}} {}

    /// The line was silent for longer than a slave may take to answer: the next telegram is a request, also where no
    /// direction was known before.
    constexpr void request_timed_out() noexcept { this->scheme().request_timed_out(); }
};

using reader = basic_reader<>;

}  // namespace drivecodec::fc
