#pragma once

// What the fuzzers of stream readers have in common: events on a line, the ways to feed a reader, and a mutator that
// plants valid frames.
//
// Input: what to expect and how to feed, own address, how many events, the events (bytes to wait, kind), the stream.

#include "fuzz_common.hpp"
#include "input.hpp"

#include <drivecodec/core/stream_item.hpp>

#include <vector>

namespace stream {

using drivecodec::bytes;
using drivecodec::errc;

enum class event_kind : std::uint8_t { chunk, silence, timeout };

struct event {
    std::size_t at;
    event_kind  kind;
};

/// How the library's reader gets its bytes.
enum class feeding : std::uint8_t {
    byte_by_byte,  // and looks after each
    in_chunks,     // as the events tell
    until_full,    // looks only when there is no room, or when it must
    committed,     // in pieces straight into the buffer
};

struct item {
    bool        is_frame = false;
    std::size_t begin    = 0;
    std::size_t size     = 0;
    errc        reason   = errc::none;  // of dropped bytes
    int         read_as  = 0;           // of a frame: its direction
    bool        aligned  = false;

    friend bool operator==(item const&, item const&) = default;
};

struct scenario {
    unsigned           what = 0;  // of three things to expect
    std::uint8_t       own  = 0;
    feeding            how  = feeding::in_chunks;
    std::vector<event> events;
    bytes              stream;
};

inline constexpr std::size_t max_events = 32;

[[nodiscard]] inline scenario parse(fuzz_input input)
{
    scenario   made;
    auto const what   = input.u8();
    made.what         = what % 3U;
    made.how          = static_cast<feeding>(1 + what / 3 % 3);
    made.own          = input.u8();
    auto const  count = input.u8() % max_events;
    std::size_t at    = 0;
    for (std::size_t i = 0; i < count; ++i) {
        at += input.u8();
        auto const kind = input.u8() % 4;
        made.events.push_back({at, kind == 3 ? event_kind::silence : static_cast<event_kind>(kind)});
    }
    made.stream = input.rest();
    for (auto& e : made.events) { e.at = e.at < made.stream.size() ? e.at : made.stream.size(); }
    made.events.push_back({made.stream.size(), event_kind::silence});
    return made;
}

/// Feeds `Reader`. `Frames::direction_of(frame)` looks at a frame and gives its direction.
template <typename Reader, typename Frames>
class fed_reader {
public:
    fed_reader(Reader const& fresh, scenario const& told, feeding how) : reader_{fresh}, stream_{told.stream}, how_{how}
    {}

    void on(event e)
    {
        feed(stream_.subspan(fed_, e.at - fed_));
        fed_ = e.at;
        switch (e.kind) {
        case event_kind::chunk:
            if (how_ != feeding::until_full) { look(); }
            break;
        case event_kind::silence:
            reader_.silence();
            if (how_ == feeding::until_full and reader_.prepare().empty()) {
                FUZZ_ASSERT(reader_.push(stream_.subspan(fed_)).size() == stream_.size() - fed_);
            }
            look();
            break;
        case event_kind::timeout:
            look();
            reader_.request_timed_out();
            look();
            break;
        }
    }

    [[nodiscard]] drivecodec::stream_counters const& counters() const { return reader_.counters(); }

    std::vector<item> items;

private:
    void feed(bytes rest)
    {
        while (not rest.empty()) {
            auto const before = rest.size();
            switch (how_) {
            case feeding::byte_by_byte:
                FUZZ_ASSERT(reader_.push(rest.first(1)).empty());
                rest = rest.subspan(1);
                look();
                break;
            case feeding::in_chunks:
            case feeding::until_full:
                rest = reader_.push(rest);
                if (not rest.empty()) { look(); }
                break;
            case feeding::committed: {
                auto const room = reader_.prepare();
                auto const size = rest.size() < room.size() ? rest.size() : room.size();
                auto const part = size > 7 ? size - size / 3 : size;
                drivecodec::copy_bytes(rest.first(part), room);
                reader_.commit(part);
                rest = rest.subspan(part);
                look();
                break;
            }
            }
            FUZZ_ASSERT(rest.size() < before or how_ == feeding::in_chunks or how_ == feeding::until_full);
            stuck_ = rest.size() < before ? 0 : stuck_ + 1;
            FUZZ_ASSERT(stuck_ < 2);  // there is room after `next` has given all it has
        }
    }

    void look()
    {
        while (auto const next = reader_.next()) {
            item  found{.begin = given_};
            bytes raw;
            if (auto const* frame = next.frame()) {
                raw            = frame->raw;
                found.is_frame = true;
                found.read_as  = Frames::direction_of(*frame);
                found.aligned  = frame->aligned;
            } else {
                FUZZ_ASSERT(next.dropped() != nullptr);
                raw          = next.dropped()->raw;
                found.reason = next.dropped()->reason;
                FUZZ_ASSERT(not raw.empty() and raw.size() <= Reader::max_run);
            }
            found.size = raw.size();
            FUZZ_ASSERT(given_ + raw.size() <= stream_.size());
            FUZZ_ASSERT(drivecodec::same_bytes(raw, stream_.subspan(given_, raw.size())));  // each byte, once, in order
            given_ += raw.size();
            items.push_back(found);
        }
    }

    Reader      reader_;
    bytes       stream_;
    feeding     how_;
    std::size_t fed_ = 0, given_ = 0;
    unsigned    stuck_ = 0;
};

[[nodiscard]] inline drivecodec::stream_counters count(std::vector<item> const& items)
{
    drivecodec::stream_counters counted;
    for (auto const& i : items) {
        if (i.is_frame) {
            ++counted.frames;
            counted.unaligned_frames += i.aligned ? 0 : 1;
        } else {
            ++counted.dropped_runs;
            counted.dropped_bytes += static_cast<std::uint32_t>(i.size);
            counted.bad_checksums += i.reason == errc::bad_checksum ? 1 : 0;
            counted.truncated += i.reason == errc::truncated ? 1 : 0;
        }
    }
    return counted;
}

/// `slow` hears the events, then a reader like `fresh`, byte by byte and as the scenario tells: they say the same.
template <typename Frames, typename Reader, typename Slow>
void compare(Reader const& fresh, scenario const& told, Slow slow)
{
    for (auto const& e : told.events) { slow.on(e); }

    std::size_t given = 0;
    for (auto const& i : slow.items) { given += i.size; }
    FUZZ_ASSERT(given == told.stream.size());

    for (auto const how : {feeding::byte_by_byte, told.how}) {
        fed_reader<Reader, Frames> fast{fresh, told, how};
        for (auto const& e : told.events) { fast.on(e); }
        FUZZ_ASSERT(fast.items == slow.items);
        FUZZ_ASSERT(fast.counters() == count(slow.items));
    }
}

//=== plants valid frames ===//

class dice {
public:
    explicit dice(unsigned seed) : state_{seed * 2654435761U + 1} {}

    /// 0 to `limit` - 1.
    unsigned below(unsigned limit)
    {
        state_ = state_ * 1664525U + 1013904223U;
        return (state_ >> 16) % limit;
    }
    std::uint8_t byte() { return static_cast<std::uint8_t>(below(256)); }

private:
    std::uint32_t state_;
};

/// Mutates with `mutate`, mostly, and inserts what `any_frame(roll)` gives into the stream.
template <typename Mutate, typename AnyFrame>
std::size_t plant(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed, Mutate mutate,
                  AnyFrame any_frame)
{
    dice roll{seed};
    auto mutated = roll.below(3) != 0 ? mutate(data, size, max_size) : size;
    for (auto planted = roll.below(4); planted > 0; --planted) {
        if (mutated < 3 or (mutated > 200 and roll.below(8) != 0)) { break; }  // the shorter, the more in a second
        auto const begin = std::size_t{3} + 2 * (data[2] % max_events);
        auto const frame = any_frame(roll);
        if (begin > mutated or frame.size() > max_size - mutated) { break; }
        auto const at = roll.below(3) == 0 ? begin + roll.below(static_cast<unsigned>(mutated - begin + 1)) : mutated;
        for (auto i = mutated; i > at; --i) { data[i - 1 + frame.size()] = data[i - 1]; }
        drivecodec::copy_bytes(frame, std::span{data + at, frame.size()});
        mutated += frame.size();
    }
    return mutated;
}

}  // namespace stream
