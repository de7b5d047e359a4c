// The stream reader against a second, slow one, which looks at all the bytes that have come each time: telegrams with
// their directions, runs of dropped bytes, their order and the counters are the same, however the stream is cut into
// chunks.
//
// Input: see stream.hpp.
#include "fc/rules.hpp"
#include "stream.hpp"

#include <drivecodec/fc/reader.hpp>

namespace {

namespace fc = drivecodec::fc;
using drivecodec::bytes;
using drivecodec::errc;
using fc::direction;
using stream::event;
using stream::event_kind;
using stream::scenario;

//=== the slow reader ===//

template <typename Layout>
class slow_reader {
public:
    slow_reader(scenario const& told)
        : what_{static_cast<fc::expecting>(told.what)}, own_{rules::slave_of(told.own)}, stream_{told.stream}
    {}

    void on(event e)
    {
        end_ = e.at;
        run(e.kind == event_kind::silence);
        if (e.kind == event_kind::timeout) { last_ = direction::response; }  // a request is next
    }

    std::vector<stream::item> items;

private:
    void run(bool is_silent)
    {
        while (front_ < end_) {
            auto const front = stream_.subspan(front_, end_ - front_);
            auto const fault = fault_of(front);
            if (fault == errc::truncated and not is_silent) { return; }
            fault == errc::none ? give_frame(front.first(front[1] + std::size_t{2})) : drop(fault);
        }
        if (is_silent) {
            give_run();
            unaligned_ = false;
        }
    }

    [[nodiscard]] static errc fault_of(bytes front)
    {
        if (front[0] != 0x02) { return errc::bad_length; }
        if (front.size() == 1) { return errc::truncated; }
        auto const size = front[1] + std::size_t{2};
        if (size < 8 or size > 256) { return errc::bad_length; }  // the shortest of any layout
        if (size > front.size()) { return errc::truncated; }
        return has_reference_bcc(front.first(size)) ? errc::none : errc::bad_checksum;
    }

    [[nodiscard]] direction direction_of(bytes telegram) const
    {
        auto const adr = telegram[2];
        if (what_ == fc::expecting::request) { return direction::request; }
        if (what_ == fc::expecting::response) { return direction::response; }
        if (rules::is_broadcast(adr) or (own_ != 0 and rules::slave_of(adr) == own_)) { return direction::request; }
        if (telegram.size() == 12 + 2 * Layout::process_words) {
            auto const ak = rules::ak_of(rules::data_of(telegram));
            if (ak == 0xD or ak == 0xE or (ak == 0x3 and Layout::parameter_number_bits == 11)) {
                return direction::request;
            }
            if (ak == 0x7) { return direction::response; }
        }
        if (last_ == direction::unknown) { return direction::unknown; }
        return last_ == direction::request and adr == last_adr_ ? direction::response : direction::request;
    }

    void give_frame(bytes telegram)
    {
        give_run();
        last_     = direction_of(telegram);
        last_adr_ = telegram[2];
        items.push_back({true, front_, telegram.size(), errc::none, static_cast<int>(last_), not unaligned_});
        unaligned_ = false;
        front_ += telegram.size();
        head_ = front_;
    }

    void drop(errc reason)
    {
        if (front_ == head_) { reason_ = reason; }
        unaligned_ = true;
        ++front_;
        if (front_ - head_ == fc::basic_reader<Layout>::max_run) { give_run(); }
    }

    void give_run()
    {
        if (front_ != head_) { items.push_back({.begin = head_, .size = front_ - head_, .reason = reason_}); }
        head_ = front_;
    }

    fc::expecting what_;
    unsigned      own_;  // 0: none
    bytes         stream_;
    std::size_t   end_ = 0, head_ = 0, front_ = 0;
    errc          reason_    = errc::none;
    bool          unaligned_ = false;
    direction     last_      = direction::unknown;
    std::uint8_t  last_adr_  = 0;
};

struct frames {
    [[nodiscard]] static int direction_of(fc::frame const& found)
    {
        auto const raw = found.raw;
        FUZZ_ASSERT(rules::fault_of(raw, 4, 252).code == errc::none or rules::is_reserved(raw[2]));
        FUZZ_ASSERT(has_reference_bcc(raw) and raw[0] == 0x02 and raw.size() == raw[1] + std::size_t{2});
        FUZZ_ASSERT(found.address().byte() == raw[2] and rules::is_same(found.data(), rules::data_of(raw)));
        FUZZ_ASSERT(found.ak() == rules::ak_of(rules::data_of(raw)));
        return static_cast<int>(found.direction);
    }
};

template <typename Layout>
void compare(scenario const& told)
{
    using reader    = fc::basic_reader<Layout>;
    auto const what = static_cast<fc::expecting>(told.what);
    auto const own  = fc::address::from_byte(told.own);
    stream::compare<frames>(told.own == 0 ? reader{what} : reader{what, own}, told, slow_reader<Layout>{told});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    auto const told = stream::parse({data, size});
    compare<fc::vlt_layout>(told);
    compare<fc::data_layout<4, 12>>(told);
    return 0;
}

#ifdef FUZZ_ENGINE

namespace {

/// A telegram of some kind, from or to one of few slaves.
std::vector<std::uint8_t> any_telegram(stream::dice& roll)
{
    constexpr std::uint8_t sizes[]  = {8, 8, 16, 16, 16, 12, 20, 24};
    constexpr std::uint8_t slaves[] = {0x01, 0x01, 0x01, 0x02, 0x81, 0x20, 0x80, 0x00};

    auto const size = roll.below(8) == 0 ? 12 + roll.below(roll.below(8) == 0 ? 245 : 30) : sizes[roll.below(8)];
    std::vector<std::uint8_t> made(size);
    for (auto& byte : made) { byte = roll.below(4) == 0 ? roll.byte() : static_cast<std::uint8_t>(roll.below(9)); }
    made[0] = 0x02;
    made[1] = static_cast<std::uint8_t>(size - 2);
    made[2] = roll.below(16) == 0 ? roll.byte() : slaves[roll.below(8)];
    made[3] = static_cast<std::uint8_t>(roll.below(16) << 4);
    repair_bcc(made);
    if (roll.below(16) == 0) { made[roll.below(static_cast<unsigned>(made.size()))] ^= 1; }
    if (roll.below(16) == 0) { made.pop_back(); }
    return made;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed)
{
    return stream::plant(data, size, max_size, seed, LLVMFuzzerMutate, any_telegram);
}

#endif
