// The stream reader against a second, slow one, which looks at all the bytes that have come each time: frames, runs of
// dropped bytes, their order and the counters are the same, however the stream is cut into chunks.
//
// Input: see stream.hpp.
#include "repair_crc16.hpp"
#include "stream.hpp"

#include <drivecodec/modbus/rtu/reader.hpp>

namespace {

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;
using drivecodec::bytes;
using drivecodec::errc;
using modbus::direction;
using stream::event;
using stream::event_kind;
using stream::item;
using stream::scenario;

//=== the slow reader ===//

class slow_reader {
public:
    slow_reader(scenario const& told)
        : what_{static_cast<rtu::expecting>(told.what)}, own_{told.own}, stream_{told.stream}
    {}

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
        items.push_back({true, front_, chosen.size, errc::none, static_cast<int>(chosen.read_as), not unaligned_});
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

struct frames {
    [[nodiscard]] static int direction_of(rtu::frame const& found)
    {
        auto const raw = found.raw;
        FUZZ_ASSERT(has_reference_crc16(raw) and raw.size() >= 4 and raw.size() <= 256);
        FUZZ_ASSERT(found.address() == raw[0] and modbus::to_byte(found.function()) == (raw[1] & 0x7F));
        FUZZ_ASSERT(found.is_exception() == (raw[1] >= 0x80) and found.pdu().size() == raw.size() - 3);
        return static_cast<int>(found.direction);
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    auto const told = stream::parse({data, size});
    auto const what = static_cast<rtu::expecting>(told.what);
    stream::compare<frames>(
        told.own == 0 ? rtu::reader{what} : rtu::reader{what, rtu::server_address::reserved(told.own)}, told,
        slow_reader{told});
    return 0;
}

//=== plants valid frames ===//

#ifdef FUZZ_ENGINE

namespace {

/// A frame of a length that its header announces; its fields are anything.
std::vector<std::uint8_t> any_frame(stream::dice& roll)
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
    return stream::plant(data, size, max_size, seed, LLVMFuzzerMutate, any_frame);
}

#endif
