#pragma once

#include <drivecodec/core/bytes.hpp>
#include <drivecodec/core/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

// A stream reader must say what the rule says. The rule is here a second time, in the plainest form: it sees all bytes up
// to the next silence at once, keeps nothing but a position, and does not care for speed.

namespace stream_model {

using drivecodec::bytes;
using drivecodec::errc;
using byte_list = std::vector<std::uint8_t>;

//=== what happens on a line: a list of bytes and of what is not a byte ===//

inline constexpr int silence = -1;
inline constexpr int timeout = -2;  // nobody answered
using line                   = std::vector<int>;

template <typename... Parts>
[[nodiscard]] line line_of(Parts const&... parts)
{
    line       made;
    auto const append = [&made](auto const& part) {
        if constexpr (requires { part.begin(); }) {
            made.insert(made.end(), part.begin(), part.end());
        } else {
            made.push_back(part);
        }
    };
    (append(parts), ...);
    return made;
}

[[nodiscard]] inline std::string to_text(auto const& list)
{
    std::string text;
    for (int const byte : list) {
        std::array<char, 8> digits{};
        std::snprintf(digits.data(), digits.size(), "%02X ", static_cast<unsigned>(byte & 0xFF));
        text += byte == silence ? "/ " : byte == timeout ? "! " : digits.data();
    }
    return text;
}

[[nodiscard]] inline byte_list bytes_of(line const& heard)
{
    byte_list made;
    for (auto const what : heard) {
        if (what >= 0) { made.push_back(static_cast<std::uint8_t>(what)); }
    }
    return made;
}

//=== chance ===//

/// The same numbers on every machine.
class dice {
public:
    explicit dice(unsigned seed) : random_{seed} {}

    /// 0 to `count` - 1.
    [[nodiscard]] unsigned below(std::size_t count) { return static_cast<unsigned>(random_() % count); }
    [[nodiscard]] bool         one_in(unsigned count) { return below(count) == 0; }
    [[nodiscard]] std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }
    [[nodiscard]] byte_list    noise(std::size_t size)
    {
        byte_list made(size);
        for (auto& b : made) { b = byte(); }
        return made;
    }

private:
    std::mt19937 random_;
};

//=== what a reader says of it ===//

struct item {
    bool      is_frame = false;
    int       kind     = 0;      // of a frame: what it was read as
    bool      aligned  = false;  // of a frame
    errc      reason   = errc::none;
    byte_list raw{};

    friend bool operator==(item const&, item const&) = default;
    friend void PrintTo(item const& i, std::ostream* out)
    {
        *out << (i.is_frame ? i.aligned ? "frame " : "unaligned frame " : "dropped ")
             << (i.is_frame ? i.kind : static_cast<int>(i.reason)) << ": " << to_text(i.raw);
    }
};

[[nodiscard]] inline item frame(int kind, auto const& raw, bool aligned = true)
{
    return {.is_frame = true, .kind = kind, .aligned = aligned, .raw = {raw.begin(), raw.end()}};
}
[[nodiscard]] inline item dropped(errc reason, auto const& raw)
{
    return {.reason = reason, .raw = {raw.begin(), raw.end()}};
}

//=== the rule ===//

/// What one reading says of the bytes at the front.
struct reading {
    enum class what { has_size, needs_more, until_silence, impossible };

    int         kind;
    what        says;
    std::size_t size = 0;
};

/// `Rules`: `readings(front)` in order, `is_intact(frame)`, `took(kind, frame)`, `timed_out()`, `min_size`, `max_size`.
template <typename Rules>
class decision {
public:
    decision(Rules rules, std::size_t max_run) : rules_{rules}, max_run_{max_run} {}

    [[nodiscard]] std::vector<item> operator()(line const& heard)
    {
        for (auto const what : heard) {
            if (what >= 0) {
                all_.push_back(static_cast<std::uint8_t>(what));
                continue;
            }
            decide(what == silence);
            if (what == timeout) { rules_.timed_out(); }
        }
        decide(false);
        return items_;
    }

private:
    void decide(bool closed)
    {
        while (at_ < all_.size()) {
            auto const front  = bytes{all_}.subspan(at_);
            auto       reason = errc::bad_length;
            auto       found  = std::size_t{0};
            for (auto const& reading : rules_.readings(front)) {
                auto size = reading.size;
                if (reading.says == reading::what::until_silence and aligned_ and front.size() <= Rules::max_size) {
                    if (not closed) { return; }
                    size = front.size();
                } else if (reading.says == reading::what::until_silence or reading.says == reading::what::impossible) {
                    continue;
                }
                auto const needs_more = reading.says == reading::what::needs_more;
                if (size > Rules::max_size or (size < Rules::min_size and not needs_more)) { continue; }
                if (size > front.size() or needs_more) {
                    if (not closed) { return; }
                    if (reason == errc::bad_length) { reason = errc::truncated; }
                } else if (not rules_.is_intact(front.first(size))) {
                    if (reason == errc::bad_length) { reason = errc::bad_checksum; }
                } else {
                    end_run();
                    items_.push_back(frame(reading.kind, front.first(size), aligned_));
                    rules_.took(reading.kind, front.first(size));
                    found = size;
                    break;
                }
            }
            aligned_ = found != 0;
            if (found == 0) {
                if (run_.empty()) { reason_ = reason; }
                run_.push_back(front.front());
                if (run_.size() == max_run_) { end_run(); }
                found = 1;
            }
            at_ += found;
        }
        if (closed) {
            end_run();
            aligned_ = true;
        }
    }

    void end_run()
    {
        if (not run_.empty()) { items_.push_back(dropped(reason_, run_)); }
        run_.clear();
    }

    Rules             rules_;
    std::size_t       max_run_;
    byte_list         all_{};
    std::size_t       at_      = 0;
    bool              aligned_ = true;
    byte_list         run_{};
    errc              reason_ = errc::none;
    std::vector<item> items_{};
};

//=== the ways to feed a reader ===//

enum class way { in_one_chunk, byte_by_byte, push_in_random_chunks, fill_in_random_chunks };
inline constexpr std::array all_ways{way::in_one_chunk, way::byte_by_byte, way::push_in_random_chunks,
                                     way::fill_in_random_chunks};

/// Everything that `reader` has to say, in `said`. `kind_of(frame)` is what a frame was read as.
template <typename Reader, typename KindOf>
void take_all(Reader& reader, KindOf kind_of, std::vector<item>& said)
{
    while (auto const given = reader.next()) {
        if (auto const* whole = given.frame()) {
            said.push_back(frame(kind_of(*whole), whole->raw, whole->aligned));
        } else {
            said.push_back(dropped(given.dropped()->reason, given.dropped()->raw));
        }
    }
}

/// What `reader` says of `heard`.
template <typename Reader, typename KindOf>
[[nodiscard]] std::vector<item> read(Reader& reader, line const& heard, way how, KindOf kind_of, unsigned seed = 1)
{
    std::mt19937      random{seed};
    std::vector<item> said;
    byte_list         chunk;
    auto const        feed = [&] {
        for (bytes rest{chunk}; not rest.empty();) {
            auto const before = rest.size();
            if (how == way::fill_in_random_chunks) {
                auto const room = reader.prepare();
                auto const size = std::min({std::size_t{1 + random() % 50}, room.size(), rest.size()});
                std::copy_n(rest.begin(), size, room.begin());
                reader.commit(size);
                rest = rest.subspan(size);
            } else {
                auto const size = how == way::in_one_chunk ? rest.size()
                                  : how == way::byte_by_byte
                                      ? std::size_t{1}
                                      : std::min(std::size_t{1 + random() % (random() % 2 == 0 ? 4 : 400)}, rest.size());
                auto const left = reader.push(rest.first(size));
                rest            = rest.subspan(size - left.size());
            }
            take_all(reader, kind_of, said);
            if (rest.size() == before) {
                ADD_FAILURE() << "no room after next() gave all: " << to_text(heard);
                return;
            }
        }
        chunk.clear();
    };
    for (auto const what : heard) {
        if (what >= 0) {
            chunk.push_back(static_cast<std::uint8_t>(what));
            continue;
        }
        feed();
        if (what == silence) { reader.silence(); }
        if constexpr (requires { reader.request_timed_out(); }) {
            if (what == timeout) { reader.request_timed_out(); }
        }
        take_all(reader, kind_of, said);
    }
    feed();
    return said;
}

/// All bytes of the items, in order.
[[nodiscard]] inline byte_list bytes_of(std::vector<item> const& said)
{
    byte_list made;
    for (auto const& i : said) { made.insert(made.end(), i.raw.begin(), i.raw.end()); }
    return made;
}

/// The counters that belong to the items.
template <typename Counters>
[[nodiscard]] Counters counters_of(std::vector<item> const& said)
{
    Counters counted;
    for (auto const& i : said) {
        counted.frames += i.is_frame ? 1 : 0;
        counted.unaligned_frames += i.is_frame and not i.aligned ? 1 : 0;
        counted.dropped_runs += i.is_frame ? 0 : 1;
        counted.dropped_bytes += static_cast<std::uint32_t>(i.is_frame ? 0 : i.raw.size());
        counted.bad_checksums += not i.is_frame and i.reason == errc::bad_checksum ? 1 : 0;
        counted.truncated += not i.is_frame and i.reason == errc::truncated ? 1 : 0;
    }
    return counted;
}

}  // namespace stream_model
