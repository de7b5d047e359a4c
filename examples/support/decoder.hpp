// SPDX-License-Identifier: MIT
#pragma once

#include "traffic_item.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

// Bytes of a line in, what was found in them out.

namespace support {

/// What decodes the bytes of a line, of one protocol or another.
class decoder {
public:
    decoder()                          = default;
    decoder(decoder const&)            = delete;
    decoder& operator=(decoder const&) = delete;
    virtual ~decoder()                 = default;

    virtual void push(drivecodec::bytes received) = 0;
    virtual void silence()                        = 0;

    /// Nobody answered the last request, nor will: a request comes next.
    virtual void request_timed_out() = 0;

    /// No more bytes come. `is_whole`: these were all there are, not what was heard until someone stopped listening.
    virtual void end(bool is_whole) = 0;

    [[nodiscard]] virtual bool                        is_waiting_for_response() const = 0;
    [[nodiscard]] virtual drivecodec::stream_counters counters() const                = 0;
};

/// A decoder of one protocol that can say what it found where: offsets in the stream since it began.
class protocol_decoder : public decoder {
public:
    struct findings {
        std::uint64_t                judged = 0;          ///< The item of every byte before it is given.
        std::optional<std::uint64_t> first_begin;         ///< Of the first frame that counts.
        std::optional<std::uint64_t> second_end;          ///< Of the second.
        bool                         is_aligned = false;  ///< The first began after a silence.
    };

    [[nodiscard]] findings const& found() const { return found_; }

protected:
    void count_frame(std::size_t size, bool is_aligned)
    {
        if (not found_.first_begin) {
            found_.first_begin = found_.judged;
            found_.is_aligned  = is_aligned;
        } else if (not found_.second_end) {
            found_.second_end = found_.judged + size;
        }
    }
    void pass(std::size_t size) { found_.judged += size; }

private:
    findings found_;
};

/// Feeds a stream reader, and gives what it finds; pairs replies with the requests before them.
///
/// A slave may speak once it is asked, until the next frame: every frame that is not the reply ends the waiting.
template <typename Reader>
class reader_decoder : public protocol_decoder {
public:
    using frame = typename Reader::frame;

    reader_decoder(Reader reader, style how, sink out) : reader_{std::move(reader)}, style_{how}, out_{std::move(out)}
    {}

    void push(drivecodec::bytes received) final
    {
        while (not received.empty()) {
            received = reader_.push(received);
            give_all();
        }
    }

    void silence() final
    {
        reader_.silence();
        give_all();
    }

    void request_timed_out() final
    {
        reader_.request_timed_out();
        give_up_waiting(silence_until::time_out);
        forget_request();
        give_all();
    }

    void end(bool is_whole) final
    {
        if (is_whole) { give_up_waiting(silence_until::end); }
    }

    [[nodiscard]] bool                        is_waiting_for_response() const override { return asked_.has_value(); }
    [[nodiscard]] drivecodec::stream_counters counters() const final { return reader_.counters(); }

protected:
    /// What a frame is, without its text; `is_answer` is yet to be found out.
    [[nodiscard]] virtual traffic_item item_of(frame const& heard) const = 0;

    /// Is a reply of the one that was asked the reply to that request?
    [[nodiscard]] virtual bool answers_request(frame const&) const { return true; }

    /// Writes text and meaning. What has to be known of a request until its reply comes is to be remembered here.
    virtual void describe(frame const& heard, traffic_item& item) = 0;

    /// Whom a frame would be to or from that begins with these bytes, of which something is wrong.
    [[nodiscard]] virtual std::optional<std::uint8_t> damaged_address(drivecodec::bytes raw) const = 0;

    /// Does this frame tell of the protocol?
    [[nodiscard]] virtual bool is_typical(frame const&) const { return true; }

    virtual void forget_request() = 0;

    [[nodiscard]] style how() const { return style_; }

private:
    void give_all()
    {
        while (auto const item = reader_.next()) {
            if (auto const* heard = item.frame()) {
                if (is_typical(*heard)) { this->count_frame(heard->raw.size(), heard->aligned); }
                give(*heard);
            } else if (auto const* run = item.dropped()) {
                give(*run);
            }
        }
    }

    void give(frame const& heard)
    {
        auto item      = item_of(heard);
        item.size      = heard.raw.size();
        item.is_answer = item.is_reply() and asked_ == item.address and answers_request(heard);
        if (item.is_answer) {
            asked_.reset();
        } else {
            give_up_waiting(silence_until::next_frame);
        }
        describe(heard, item);
        if (item.expects_reply) { asked_ = item.address; }
        out_(item);
        this->pass(item.size);
    }

    void give(drivecodec::dropped_bytes const& run)
    {
        auto const reason = run.reason;
        auto const begins = reason == drivecodec::errc::bad_checksum or reason == drivecodec::errc::truncated;
        out_({.kind         = traffic::dropped,
              .address      = asked_,
              .seems_from   = begins ? damaged_address(run.raw) : std::nullopt,
              .is_bad_check = reason == drivecodec::errc::bad_checksum,
              .size         = run.raw.size(),
              .text         = line_of(run, style_ == style::json)});
        this->pass(run.raw.size());
    }

    void give_up_waiting(silence_until when)
    {
        if (not asked_) { return; }
        out_({.kind = traffic::unanswered, .address = asked_, .until = when});
        asked_.reset();
    }

    Reader                      reader_;
    style                       style_;
    sink                        out_;
    std::optional<std::uint8_t> asked_;  // who has not replied yet
};

}  // namespace support
