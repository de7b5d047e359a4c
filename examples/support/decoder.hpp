// SPDX-License-Identifier: MIT
#pragma once

#include "json.hpp"
#include "stream_json.hpp"

#include <drivecodec/text/core.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

// Bytes of a line in, lines of text or JSON out.

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

/// A thing as a line of JSON, or of text.
template <typename Thing>
[[nodiscard]] std::string line_of(Thing const& thing, bool json)
{
    if (json) { return to_json(thing); }
    std::array<char, 1024> buffer;
    return std::string{drivecodec::describe(thing, buffer)};
}

/// The line of a frame, and what it means to a drive: a line below it, or in JSON one more member.
[[nodiscard]] inline std::string with_meaning(std::string line, std::string const& meaning, bool json)
{
    if (meaning.empty()) { return line; }
    if (not json) { return line + "\n    " + meaning; }
    line.pop_back();
    return line + ",\"meaning\":" + json_text(meaning) + '}';
}

/// A decoder of one protocol that can say what it found where: offsets in the stream since it began.
class protocol_decoder : public decoder {
public:
    struct findings {
        std::uint64_t                judged = 0;          ///< The line of every byte before it is written.
        std::optional<std::uint64_t> first_begin;         ///< Of the first frame that counts.
        std::optional<std::uint64_t> second_end;          ///< Of the second.
        bool                         is_aligned = false;  ///< The first began after a silence.
    };

    void                          end(bool) final {}
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

/// Feeds a stream reader and writes what it finds.
template <typename Reader>
class reader_decoder : public protocol_decoder {
public:
    using frame = typename Reader::frame;

    reader_decoder(Reader reader, bool json, std::ostream& out) : reader_{std::move(reader)}, json_{json}, out_{out} {}

    void push(drivecodec::bytes received) final
    {
        while (not received.empty()) {
            received = reader_.push(received);
            write_all();
        }
    }

    void silence() final
    {
        reader_.silence();
        write_all();
    }

    void request_timed_out() final
    {
        reader_.request_timed_out();
        forget_request();
        write_all();
    }

    [[nodiscard]] drivecodec::stream_counters counters() const final { return reader_.counters(); }

protected:
    /// The line of a frame, or its lines, without the newline at the end.
    [[nodiscard]] virtual std::string lines_of(frame const& heard) = 0;

    /// Does this frame tell of the protocol?
    [[nodiscard]] virtual bool is_typical(frame const&) const { return true; }

    virtual void forget_request() = 0;

    [[nodiscard]] bool json() const { return json_; }

private:
    void write_all()
    {
        while (auto const item = reader_.next()) {
            if (auto const* heard = item.frame()) {
                if (is_typical(*heard)) { this->count_frame(heard->raw.size(), heard->aligned); }
                out_ << lines_of(*heard) << '\n';
                this->pass(heard->raw.size());
            } else if (auto const* run = item.dropped()) {
                out_ << line_of(*run, json_) << '\n';
                this->pass(run->raw.size());
            }
        }
        out_.flush();
    }

    Reader        reader_;
    bool          json_;
    std::ostream& out_;
};

}  // namespace support
