// The stream reader against a second, slow one, which looks at all the bytes that have come each time: frames, runs of
// dropped bytes, their order and the counters are the same, however the stream is cut into chunks.
//
// Input: what to expect and how to feed, own address, how many events, the events (bytes to wait, kind), the stream.
#include "fuzz_common.hpp"
#include "input.hpp"
#include "repair_crc16.hpp"

#include <drivecodec/modbus/rtu/reader.hpp>

#include <vector>

namespace {

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;
using drivecodec::bytes;
using drivecodec::errc;
using modbus::direction;

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
    bool        is_frame  = false;
    std::size_t begin     = 0;
    std::size_t size      = 0;
    errc        reason    = errc::none;            // of dropped bytes
    direction   read_as   = direction::request;    // of a frame
    bool        aligned   = false;

    friend bool operator==(item const&, item const&) = default;
};

struct scenario {
    rtu::expecting     what = rtu::expecting::either;
    std::uint8_t       own  = 0;
    feeding            how  = feeding::in_chunks;
    std::vector<event> events;
    bytes              stream;
};

constexpr std::size_t max_events = 32;

[[nodiscard]] scenario parse(fuzz_input input)
{
    scenario   made;
    auto const what = input.u8();
    made.what       = static_cast<rtu::expecting>(what % 3);
    made.how        = static_cast<feeding>(1 + what / 3 % 3);
    made.own        = input.u8();
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

//=== the slow reader ===//

class slow_reader {
public:
    slow_reader(scenario const& told) : what_{told.what}, own_{told.own}, stream_{told.stream} {}

    void on(event e)
    {
        end_ = e.at;
        if (e.kind == event_kind::silence) {
            run(true);
            unaligned_ = false;
        } else {
            run(false);
            if (e.kind == event_kind::timeout) { asked_ = false; }
            run(false);
        }
    }

    std::vector<item> items;

private:
    struct reading {
        direction   read_as;
        std::size_t size;  // of the whole frame; 0: not known yet, or impossible
        errc        fault;
    };

    [[nodiscard]] reading judge(direction read_as, bool has_mei, bool is_silent) const
    {
        constexpr auto impossible = errc::bad_length;
        auto const     front      = stream_.subspan(front_, end_ - front_);
        if (front.size() < 2) { return {read_as, 0, errc::truncated}; }
        auto const pdu    = front.subspan(1);
        auto const length = read_as == direction::request ? modbus::public_functions::request_length(pdu)
                                                          : modbus::public_functions::response_length(pdu);
        std::size_t size = 0;
        if (has_mei) {
            if (read_as != direction::response or pdu[0] != 0xAB) { return {read_as, 0, impossible}; }
            size = 6;
        } else if (length.is_impossible()) {
            return {read_as, 0, impossible};
        } else if (length.is_until_silence()) {
            if (unaligned_ or front.size() > 256) { return {read_as, 0, impossible}; }
            if (not is_silent) { return {read_as, 0, errc::truncated}; }
            size = front.size();
        } else if (length.is_open()) {
            return {read_as, 0, length.size() + 1 > 256 ? impossible : errc::truncated};
        } else {
            size = length.size() + 3;
        }
        if (size > 256) { return {read_as, 0, impossible}; }
        if (size > front.size()) { return {read_as, 0, errc::truncated}; }
        if (size < 4) { return {read_as, 0, impossible}; }
        return {read_as, size, has_reference_crc16(front.first(size)) ? errc::none : errc::bad_checksum};
    }

    void run(bool is_silent)
    {
        while (front_ < end_) {
            auto const address  = stream_[front_];
            auto const function = front_ + 1 < end_ ? stream_[front_ + 1] & 0x7F : 0;
            auto const is_own   = own_ != 0 and address == own_;
            auto       first    = direction::request;
            if (not is_own and what_ != rtu::expecting::request) {
                auto const is_answer = asked_ and address == asked_address_ and function == asked_function_;
                if (what_ == rtu::expecting::response or is_answer) { first = direction::response; }
            }
            auto const both   = what_ == rtu::expecting::either and not is_own;
            auto const second = first == direction::request ? direction::response : direction::request;

            errc reason = errc::bad_length;
            bool decided = false;
            for (unsigned i = 0; i < (both ? 4U : 2U) and not decided; ++i) {
                auto const judged = judge(i < 2 ? first : second, i % 2 != 0, is_silent);
                if (judged.fault == errc::none) {
                    give_frame(judged);
                    decided = true;
                } else if (judged.fault == errc::truncated and not is_silent) {
                    return;
                } else if (reason == errc::bad_length) {
                    reason = judged.fault;
                }
            }
            if (not decided) { drop(reason); }
        }
        if (is_silent) { give_run(); }
    }

    void give_frame(reading const& chosen)
    {
        give_run();
        items.push_back({true, front_, chosen.size, errc::none, chosen.read_as, not unaligned_});
        auto const frame = stream_.subspan(front_, chosen.size);
        asked_           = chosen.read_as == direction::request and frame[0] != 0
                 and not(frame[1] == 8 and frame.size() >= 6 and frame[2] == 0 and frame[3] == 4);
        asked_address_  = frame[0];
        asked_function_ = frame[1] & 0x7F;
        unaligned_      = false;
        front_ += chosen.size;
        head_ = front_;
    }

    void drop(errc reason)
    {
        if (front_ == head_) { reason_ = reason; }
        unaligned_ = true;
        ++front_;
        if (front_ - head_ == rtu::reader::max_run) { give_run(); }
    }

    void give_run()
    {
        if (front_ != head_) { items.push_back({.begin = head_, .size = front_ - head_, .reason = reason_}); }
        head_ = front_;
    }

    rtu::expecting what_;
    std::uint8_t   own_;
    bytes          stream_;
    std::size_t    end_ = 0, head_ = 0, front_ = 0;
    errc           reason_         = errc::none;
    bool           unaligned_      = false;
    bool           asked_          = false;
    std::uint8_t   asked_address_  = 0;
    int            asked_function_ = 0;
};

//=== the library's ===//

class fast_reader {
public:
    fast_reader(scenario const& told, feeding how) : stream_{told.stream}, how_{how}
    {
        reader_ = told.own == 0 ? rtu::reader{told.what} : rtu::reader{told.what, rtu::server_address::reserved(told.own)};
    }

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
            item found{.begin = given_};
            bytes raw;
            if (auto const* frame = next.frame()) {
                raw            = frame->raw;
                found.is_frame = true;
                found.read_as  = frame->direction;
                found.aligned  = frame->aligned;
                FUZZ_ASSERT(has_reference_crc16(raw) and raw.size() >= 4 and raw.size() <= 256);
                FUZZ_ASSERT(frame->address() == raw[0] and modbus::to_byte(frame->function()) == (raw[1] & 0x7F));
                FUZZ_ASSERT(frame->is_exception() == (raw[1] >= 0x80) and frame->pdu().size() == raw.size() - 3);
            } else {
                FUZZ_ASSERT(next.dropped() != nullptr);
                raw          = next.dropped()->raw;
                found.reason = next.dropped()->reason;
                FUZZ_ASSERT(not raw.empty() and raw.size() <= rtu::reader::max_run);
            }
            found.size = raw.size();
            FUZZ_ASSERT(given_ + raw.size() <= stream_.size());
            FUZZ_ASSERT(drivecodec::same_bytes(raw, stream_.subspan(given_, raw.size())));  // each byte, once, in order
            given_ += raw.size();
            items.push_back(found);
        }
    }

    rtu::reader reader_;
    bytes       stream_;
    feeding     how_;
    std::size_t fed_ = 0, given_ = 0;
    unsigned    stuck_ = 0;
};

[[nodiscard]] drivecodec::stream_counters count(std::vector<item> const& items)
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    auto const  told = parse({data, size});
    slow_reader slow{told};
    for (auto const& e : told.events) { slow.on(e); }

    std::size_t given = 0;
    for (auto const& i : slow.items) { given += i.size; }
    FUZZ_ASSERT(given == told.stream.size());

    for (auto const how : {feeding::byte_by_byte, told.how}) {
        fast_reader fast{told, how};
        for (auto const& e : told.events) { fast.on(e); }
        FUZZ_ASSERT(fast.items == slow.items);
        FUZZ_ASSERT(fast.counters() == count(slow.items));
    }
    return 0;
}

//=== plants valid frames ===//

#ifdef FUZZ_ENGINE

namespace {

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

/// A frame of a length that its header announces; its fields are anything.
std::vector<std::uint8_t> any_frame(dice& roll)
{
    constexpr std::uint8_t functions[] = {0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0x08, 0x0B, 0x0C, 0x0F, 0x10,
                                          0x11, 0x14, 0x15, 0x16, 0x17, 0x18, 0x2B, 0x2B, 0x41, 0x83, 0xAB};
    auto const small    = [&] { return roll.below(4) == 0 ? roll.byte() : static_cast<std::uint8_t>(roll.below(9)); };
    auto const function = functions[roll.below(sizeof functions)];
    auto const asks     = function < 0x80 and roll.below(2) == 0;

    std::vector<std::uint8_t> frame{static_cast<std::uint8_t>(1 + roll.below(3)), function};
    if (function == 0x2B) { frame.push_back(roll.below(4) == 0 ? 0x0D : 0x0E); }
    while (frame.size() < 254) {
        auto const pdu    = bytes{frame}.subspan(1);
        auto const length = asks ? modbus::public_functions::request_length(pdu) : modbus::public_functions::response_length(pdu);
        if (length.is_until_silence() and roll.below(4) == 0) { break; }
        if (length.is_exact() and length.size() <= pdu.size()) { break; }
        frame.push_back(small());
    }
    if (function == 0xAB and roll.below(2) == 0) { frame.push_back(small()); }
    frame.resize(frame.size() + 2);
    repair_crc16(frame);
    if (roll.below(16) == 0) { frame[roll.below(static_cast<unsigned>(frame.size()))] ^= 1; }
    if (roll.below(16) == 0) { frame.pop_back(); }
    return frame;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed)
{
    dice roll{seed};
    auto mutated = roll.below(3) != 0 ? LLVMFuzzerMutate(data, size, max_size) : size;
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

#endif
