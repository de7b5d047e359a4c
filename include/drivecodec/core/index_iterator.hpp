// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace drivecodec {

/// Walks a small view that has `size()` and `operator[]`; holds the view by value, so it outlives the view's name.
template <typename View, typename Value>
class index_iterator {
public:
    using difference_type = std::ptrdiff_t;
    using value_type      = Value;

    constexpr index_iterator() noexcept = default;
    constexpr index_iterator(View view, std::size_t index) noexcept : view_{view}, index_{index} {}

    [[nodiscard]] constexpr value_type operator*() const noexcept { return view_[index_]; }

    constexpr index_iterator& operator++() noexcept
    {
        ++index_;
        return *this;
    }
    constexpr index_iterator operator++(int) noexcept
    {
        auto const before = *this;
        ++index_;
        return before;
    }

    friend constexpr bool operator==(index_iterator const& a, index_iterator const& b) noexcept
    {
        return a.index_ == b.index_;
    }

private:
    View        view_{};
    std::size_t index_ = 0;
};

}  // namespace drivecodec
