// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>
#include <drivecodec/core/error.hpp>

#include <concepts>

namespace drivecodec {

/// Bytes that belong to no frame.
struct dropped_bytes {
    bytes raw;
    errc  reason;  ///< Of the first byte: `bad_checksum`, `bad_length` (no frame begins so), `truncated` by a silence.
};

/// What a stream reader gives: a frame, a run of dropped bytes, or nothing.
template <typename Frame>
class stream_item {
    static_assert(std::is_trivially_copyable_v<Frame>, "stream_item<Frame>: Frame must be trivially copyable");

public:
    constexpr stream_item() noexcept : nothing_{}, holds_{kind::none} {}
    constexpr stream_item(Frame whole) noexcept : frame_{whole}, holds_{kind::whole} {}
    constexpr stream_item(dropped_bytes run) noexcept : dropped_{run}, holds_{kind::run} {}

    /// Is there anything?
    constexpr explicit operator bool() const noexcept { return holds_ != kind::none; }

    /// nullptr if it is not a frame.
    [[nodiscard]] constexpr Frame const* frame() const noexcept { return holds_ == kind::whole ? &frame_ : nullptr; }

    /// nullptr if it is not a run of dropped bytes.
    [[nodiscard]] constexpr dropped_bytes const* dropped() const noexcept
    {
        return holds_ == kind::run ? &dropped_ : nullptr;
    }

private:
    enum class kind : std::uint8_t { none, whole, run };
    struct nothing {};

    union {
        nothing       nothing_;
        Frame         frame_;
        dropped_bytes dropped_;
    };
    kind holds_;
};

/// The health of a line, counted since the reader was made. They wrap around.
struct stream_counters {
    std::uint32_t frames           = 0;
    std::uint32_t unaligned_frames = 0;  ///< Of these: found inside bytes that were being dropped.
    std::uint32_t dropped_runs     = 0;
    std::uint32_t dropped_bytes    = 0;
    std::uint32_t bad_checksums    = 0;  ///< Runs that began like a frame with a wrong checksum.
    std::uint32_t truncated        = 0;  ///< Runs that began like a frame which a silence cut short.

    constexpr void count_frame(bool aligned) noexcept
    {
        ++frames;
        if (not aligned) { ++unaligned_frames; }
    }

    constexpr void count_dropped(std::size_t size, errc reason) noexcept
    {
        ++dropped_runs;
        dropped_bytes += static_cast<std::uint32_t>(size);
        if (reason == errc::bad_checksum) { ++bad_checksums; }
        if (reason == errc::truncated) { ++truncated; }
    }

    friend constexpr bool operator==(stream_counters const&, stream_counters const&) noexcept = default;
};

}  // namespace drivecodec
