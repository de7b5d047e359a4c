// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/next.hpp>
#include <drivecodec/core/index_iterator.hpp>

namespace drivecodec::cia402 {

/// A whole way from one state to another: the rows of `transitions`, in order, 0 to 5 of them.
class path {
public:
    /// From Fault reaction active to Operation enabled.
    static constexpr std::size_t max_size = 5;

    constexpr path() noexcept = default;

    /// The shortest way; what waits for the drive is part of it. Errors: `unreachable` at 0, as `next` says.
    [[nodiscard]] static constexpr result<path> between(state from, state goal, way chosen = {}) noexcept
    {
        path whole;
        for (auto present = from;;) {
            auto const now = next(present, goal, chosen);
            if (now == step::unreachable) { return error{errc::unreachable, 0}; }
            if (now == step::reached) { return whole; }
            auto const* row = find_transition(present, now.is_command() ? cause{now.command()} : awaited(present));
            whole.rows_[whole.size_++] = row;
            present                    = row->to;
        }
    }

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool        empty() const noexcept { return size_ == 0; }
    /// Precondition: index < size().
    [[nodiscard]] constexpr transition const& operator[](std::size_t index) const noexcept { return *rows_[index]; }

    [[nodiscard]] constexpr index_iterator<path, transition> begin() const noexcept { return {*this, 0}; }
    [[nodiscard]] constexpr index_iterator<path, transition> end() const noexcept { return {*this, size_}; }

private:
    /// What a drive in a state that it leaves by itself is waiting for.
    [[nodiscard]] static constexpr event awaited(state present) noexcept
    {
        return present == state::not_ready_to_switch_on ? event::initialised : event::fault_handled;
    }

    std::array<transition const*, max_size> rows_{};
    std::size_t                             size_ = 0;
};

}  // namespace drivecodec::cia402
