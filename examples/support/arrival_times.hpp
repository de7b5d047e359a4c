// SPDX-License-Identifier: MIT
#pragma once

#include "ear.hpp"

#include <cstdint>
#include <deque>
#include <optional>

namespace support {

/// When which byte of a stream came: bytes come in at the one end in chunks, and leave at the other in items.
class arrival_times {
public:
    /// When a run of bytes began and ended; nothing where that is not known.
    struct span {
        std::optional<timestamp> begin;
        std::optional<timestamp> end;
    };

    void add(std::size_t size, std::optional<timestamp> now)
    {
        end_ += size;
        if (size != 0) { chunks_.push_back({.end = end_, .time = now}); }
    }

    /// Of the next bytes, which are forgotten. Of none: the time of the one behind them, if that came.
    span take(std::size_t size)
    {
        span when{.begin = front(), .end = front()};
        taken_ += size;
        while (not chunks_.empty() and chunks_.front().end < taken_) { chunks_.pop_front(); }
        if (size != 0) { when.end = front(); }
        if (not chunks_.empty() and chunks_.front().end == taken_) { chunks_.pop_front(); }
        return when;
    }

private:
    struct chunk {
        std::uint64_t            end;
        std::optional<timestamp> time;
    };

    [[nodiscard]] std::optional<timestamp> front() const
    {
        return chunks_.empty() ? std::nullopt : chunks_.front().time;
    }

    std::deque<chunk> chunks_;
    std::uint64_t     end_ = 0, taken_ = 0;
};

}  // namespace support
