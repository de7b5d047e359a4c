// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>
#include <drivecodec/core/message_length.hpp>
#include <drivecodec/core/stream_item.hpp>

#include <array>

namespace drivecodec {

/// How the frames of a protocol lie in a stream of bytes.
///
/// The bytes at the front of the stream may be read in several ways, tried in order: `length(front, reading)` is what
/// each says of the length. `is_intact` verifies the checksum. `accept` makes the frame of a reading that was chosen,
/// and may remember it for the readings of the next.
template <typename T>
concept framing = requires(T scheme, T const asked, bytes front, unsigned reading, bool aligned) {
    { T::max_readings } -> std::convertible_to<unsigned>;
    { T::min_frame_size } -> std::convertible_to<std::size_t>;
    { T::max_frame_size } -> std::convertible_to<std::size_t>;
    { asked.length(front, reading) } noexcept -> std::same_as<message_length>;
    { T::is_intact(front) } noexcept -> std::same_as<bool>;
    { scheme.accept(front, reading, aligned) } noexcept -> std::same_as<typename T::frame>;
};

/// The stream reader: bytes in, in any chunks; whole valid frames and runs of dropped bytes out, in order.
///
///     for (bytes rest = received; not rest.empty();) {
///         rest = reader.push(rest);
///         while (auto const item = reader.next()) { ... }
///     }
///     // and when the line has been silent for the protocol's time:
///     reader.silence();
///     while (auto const item = reader.next()) { ... }
///
/// At the front of its buffer, a reading is the frame when it is complete, its checksum is right, and every earlier
/// reading is wrong or impossible. While an earlier one is incomplete it waits; `silence()` makes what is incomplete
/// impossible, and ends frames of which no field tells the length. When no reading is left, it drops one byte and looks
/// again. So what comes out does not depend on the chunks.
///
/// Each reading of each position is verified once: at most `max_readings` checksums of at most `max_frame_size` bytes
/// for each byte that comes in. A run of dropped bytes ends at a frame, at a silence, or when it has `max_run` bytes.
/// It never allocates; its size is `Capacity` and a few bytes.
///
/// One context at a time: no function may interrupt another of the same reader. All of them may run in an interrupt;
/// `commit`, `silence` and `prepare` (which at worst moves the bytes that wait) take a short bounded time, `next`
/// computes checksums. What `next` gave stays valid until the next call of a function that is not const.
template <framing Framing, std::size_t Capacity = Framing::max_frame_size + 64>
class deframer {
public:
    using frame = typename Framing::frame;

    /// Bytes that were dropped are given in runs of at most so many.
    static constexpr std::size_t max_run = Capacity - Framing::max_frame_size - 1;

    static_assert(Capacity >= Framing::max_frame_size + 2 and Capacity <= 0xFFFF,
                  "a deframer's Capacity is at least the longest frame and two bytes, at most 65535");
    static_assert(Framing::max_readings <= 8, "a deframer keeps one bit for each reading");

    /// Begins as after a silence.
    constexpr deframer() noexcept = default;
    constexpr explicit deframer(Framing framing) noexcept : framing_{framing} {}

    //=== bytes in ===//

    /// Takes bytes from the front of `chunk`; returns those for which there was no room. There is room after
    /// `next` has given all it has.
    [[nodiscard]] constexpr bytes push(bytes chunk) noexcept
    {
        auto const room = prepare();
        auto const size = chunk.size() < room.size() ? chunk.size() : room.size();
        copy_bytes(chunk.first(size), room);
        commit(size);
        return chunk.subspan(size);
    }

    /// Room for bytes to come, for read(2) or DMA: at least half of what does not wait. Empty while a silence waits for
    /// `next`. What was filled is to be committed before the next `silence`.
    [[nodiscard]] constexpr mutable_bytes prepare() noexcept
    {
        if (silent_) { return {}; }
        if (head_ == end_ or Capacity - end_ < head_) { move_to_begin(); }
        return mutable_bytes{buffer_}.subspan(end_);
    }

    /// The first `size` bytes of what `prepare` gave have been filled. Precondition: size <= prepare().size().
    constexpr void commit(std::size_t size) noexcept { end_ = static_cast<std::uint16_t>(end_ + size); }

    /// The line has been silent for as long as ends a frame: what comes next begins one.
    constexpr void silence() noexcept
    {
        if (head_ == end_) {
            unaligned_ = false;
        } else {
            silent_ = true;
        }
    }

    //=== frames out ===//

    /// The next frame or run of dropped bytes; nothing when more bytes are needed.
    [[nodiscard]] constexpr stream_item<frame> next() noexcept
    {
        while (front_ != end_) {
            if (found_size_ == 0 and not judge()) { return {}; }
            if (found_size_ != 0) { return run_size() > 0 ? take_run() : take_frame(); }
            drop_one();
            if (run_size() == max_run) { return take_run(); }
        }
        if (not silent_) { return {}; }
        if (run_size() > 0) { return take_run(); }
        silent_    = false;
        unaligned_ = false;
        return {};
    }

    /// What the framing expects has changed: the readings of the bytes that wait are judged anew.
    constexpr void reconsider() noexcept { forget(); }

    [[nodiscard]] constexpr Framing&               scheme() noexcept { return framing_; }
    [[nodiscard]] constexpr Framing const&         scheme() const noexcept { return framing_; }
    [[nodiscard]] constexpr stream_counters const& counters() const noexcept { return counters_; }

private:
    [[nodiscard]] constexpr std::size_t run_size() const noexcept { return static_cast<std::size_t>(front_ - head_); }
    [[nodiscard]] constexpr bytes waiting() const noexcept { return bytes{buffer_}.subspan(front_, end_ - front_); }

    /// Looks at the readings of the front. Returns false to wait; else `found_size_` says whether one is the frame.
    [[nodiscard]] constexpr bool judge() noexcept
    {
        auto const front   = waiting();
        auto       refuted = refuted_;  // kept out of memory, which bytes may alias
        auto       reason  = reason_;
        auto       waits   = false;
        for (unsigned reading = 0; reading < Framing::max_readings and not waits; ++reading) {
            if ((refuted >> reading & 1U) != 0) { continue; }
            auto const length = framing_.length(front, reading);
            auto const fault  = judge(front, length);
            if (fault == errc::none) {
                found_size_    = static_cast<std::uint16_t>(length.is_exact() ? length.size() : front.size());
                found_reading_ = static_cast<std::uint8_t>(reading);
                return true;
            }
            if (fault == errc::truncated and not silent_) {
                waits = true;
            } else {
                if (reason == errc::none or reason == errc::bad_length) { reason = fault; }
                refuted = static_cast<std::uint8_t>(refuted | 1U << reading);
            }
        }
        refuted_ = refuted;
        reason_  = reason;
        return not waits;
    }

    /// What is wrong with one reading; `truncated` if nothing yet.
    [[nodiscard]] constexpr errc judge(bytes front, message_length length) const noexcept
    {
        auto size = length.size();
        if (length.is_until_silence() and not unaligned_) {
            if (front.size() > Framing::max_frame_size) { return errc::bad_length; }
            if (not silent_) { return errc::truncated; }
            size = front.size();
        } else if (not length.is_exact() and not length.is_open()) {
            return errc::bad_length;
        }
        if (size > Framing::max_frame_size) { return errc::bad_length; }
        if (length.is_open()) { return errc::truncated; }
        if (size < Framing::min_frame_size) { return errc::bad_length; }
        if (size > front.size()) { return errc::truncated; }
        return Framing::is_intact(front.first(size)) ? errc::none : errc::bad_checksum;
    }

    constexpr void drop_one() noexcept
    {
        if (run_size() == 0) { run_reason_ = reason_; }
        ++front_;
        unaligned_ = true;
        forget();
    }

    [[nodiscard]] constexpr stream_item<frame> take_run() noexcept
    {
        auto const run = bytes{buffer_}.subspan(head_, run_size());
        head_          = front_;
        counters_.count_dropped(run.size(), run_reason_);
        return dropped_bytes{.raw = run, .reason = run_reason_};
    }

    [[nodiscard]] constexpr stream_item<frame> take_frame() noexcept
    {
        auto const raw     = waiting().first(found_size_);
        auto const reading = found_reading_;
        auto const aligned = not unaligned_;
        front_ = head_ = static_cast<std::uint16_t>(front_ + found_size_);
        unaligned_     = false;  // what comes directly behind a valid frame
        forget();
        counters_.count_frame(aligned);
        return framing_.accept(raw, reading, aligned);
    }

    constexpr void forget() noexcept
    {
        refuted_    = 0;
        reason_     = errc::none;
        found_size_ = 0;
    }

    constexpr void move_to_begin() noexcept
    {
        for (std::size_t i = head_; i < end_; ++i) { buffer_[i - head_] = buffer_[i]; }
        front_ = static_cast<std::uint16_t>(front_ - head_);
        end_   = static_cast<std::uint16_t>(end_ - head_);
        head_  = 0;
    }

    // All zero at the start, so that a reader with a default framing lies in .bss.
    std::array<std::uint8_t, Capacity> buffer_{};
    std::uint16_t                      head_          = 0;  // dropped bytes, not yet given
    std::uint16_t                      front_         = 0;  // bytes that wait
    std::uint16_t                      end_           = 0;
    std::uint16_t                      found_size_    = 0;  // not 0: the frame at the front
    std::uint8_t                       found_reading_ = 0;
    std::uint8_t                       refuted_       = 0;  // readings of the front, a bit each
    errc                               reason_        = errc::none;
    errc                               run_reason_    = errc::none;
    bool                               silent_        = false;
    bool                               unaligned_     = false;
    stream_counters                    counters_{};
    Framing                            framing_{};
};

}  // namespace drivecodec
