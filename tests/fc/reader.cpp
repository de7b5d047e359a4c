#include <drivecodec/fc/reader.hpp>

#include "support/fc_model.hpp"
#include "support/hex.hpp"
#include "support/verify.hpp"

#include <drivecodec/fc/parameter_requests.hpp>
#include <drivecodec/fc/slave.hpp>
#include <drivecodec/fc/text_requests.hpp>

#include <functional>

namespace {

namespace fc = drivecodec::fc;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::same_bytes;
using drivecodec::stream_counters;
using namespace drivecodec::literals;
using fc::expecting;
using fc_model::byte_list;
using fc_model::dice;
using fc_model::request;
using fc_model::response;
using fc_model::telegram_of;
using fc_model::unknown;
using stream_model::all_ways;
using stream_model::dropped;
using stream_model::frame;
using stream_model::item;
using stream_model::line;
using stream_model::line_of;
using stream_model::silence;
using stream_model::timeout;
using stream_model::way;

#ifdef __s390x__  // emulated
constexpr unsigned trials = 1'000;
#else
constexpr unsigned trials = 10'000;
#endif

constexpr auto kind_of = [](fc::frame const& f) {
    switch (f.direction) {
    case fc::direction::request: return request;
    case fc::direction::response: return response;
    default: return unknown;
    }
};

template <typename Reader>
std::vector<item> read(Reader& reader, line const& heard, way how = way::in_one_chunk, unsigned seed = 1)
{
    return stream_model::read(reader, heard, how, kind_of, seed);
}

/// What a new reader says of `heard`, after it was found to say the same however the bytes come.
template <typename Reader = fc::reader>
std::vector<item> read(line const& heard, Reader const& fresh = Reader{})
{
    auto       whole    = fresh;
    auto const expected = read(whole, heard);
    for (auto const how : all_ways) {
        auto again = fresh;
        EXPECT_EQ(read(again, heard, how), expected) << stream_model::to_text(heard);
        EXPECT_EQ(again.counters(), whole.counters()) << stream_model::to_text(heard);
    }
    EXPECT_EQ(whole.counters(), stream_model::counters_of<stream_counters>(expected));
    return expected;
}

using items = std::vector<item>;

// The manual's examples, with data that are not valid: writes 202, and the reply; reads 206, and the reply.
constexpr auto write_202    = "02 0E 01 E0 CA 00 00 00 00 03 E8 00 00 00 00 CC"_hex;
constexpr auto answer_202   = "02 0E 01 10 CA 00 00 00 00 03 E8 0F 03 20 00 10"_hex;
constexpr auto read_206     = "02 0E 01 10 CE 00 00 00 00 00 00 00 00 00 00 D3"_hex;
constexpr auto answer_206   = "02 0E 01 10 CE 00 00 00 00 00 0A 0F 03 20 00 F5"_hex;
constexpr auto start        = "02 06 01 04 7F 20 00 5E"_hex;
constexpr auto start_all    = "02 06 20 04 7F 20 00 7F"_hex;
constexpr auto read_text    = "02 0E 01 F2 6D 04 00 00 00 00 00 00 00 00 00 96"_hex;
constexpr auto answer_text  = "02 11 01 F2 6D 04 00 56 4C 54 36 30 30 30 0F 03 20 00 ED"_hex;
constexpr auto refusal      = "02 0E 01 70 CA 00 00 00 00 00 82 0F 03 20 00 19"_hex;
constexpr auto start_2      = "02 06 02 04 7F 20 00 5D"_hex;
constexpr auto start_long_1 = "02 06 81 04 7F 20 00 DE"_hex;

//=== telegrams ===//

TEST(fc_reader, takes_telegrams_of_every_kind)
{
    EXPECT_EQ(
        read(line_of(write_202, silence, answer_202, silence, read_206, silence, answer_206, silence, start, silence,
                     start, silence, read_text, silence, answer_text, silence, write_202, silence, refusal, silence)),
        (items{frame(request, write_202), frame(response, answer_202), frame(request, read_206),
               frame(response, answer_206), frame(request, start), frame(response, start), frame(request, read_text),
               frame(response, answer_text), frame(request, write_202), frame(response, refusal)}));
}

TEST(fc_reader, needs_no_silence_behind_a_telegram)
{
    EXPECT_EQ(read(line_of(start)), (items{frame(unknown, start)}));
    EXPECT_EQ(read(line_of(write_202)), (items{frame(request, write_202)}));
    for (std::size_t size = 0; size < write_202.size(); ++size) {
        EXPECT_EQ(read(line_of(bytes{write_202}.first(size))), items{});
    }
}

TEST(fc_reader, takes_two_telegrams_in_one_burst)
{
    EXPECT_EQ(read(line_of(write_202, answer_202)), (items{frame(request, write_202), frame(response, answer_202)}));
    EXPECT_EQ(read(line_of(start, write_202, start_2)),
              (items{frame(unknown, start), frame(request, write_202), frame(request, start_2)}));
}

TEST(fc_reader, takes_two_telegrams_however_they_are_chunked)
{
    constexpr auto size  = start.size() + start_2.size();
    auto const     burst = stream_model::bytes_of(line_of(start, start_2));
    for (unsigned cuts = 0; cuts < 1U << (size - 1); ++cuts) {  // all ways to cut them
        fc::reader        reader;
        std::vector<item> said;
        std::size_t       begin = 0;
        for (std::size_t end = 1; end <= size; ++end) {
            if (end < size and (cuts >> (end - 1) & 1U) == 0) { continue; }
            ASSERT_TRUE(reader.push(bytes{burst}.subspan(begin, end - begin)).empty());
            stream_model::take_all(reader, kind_of, said);
            begin = end;
        }
        ASSERT_EQ(said, (items{frame(unknown, start), frame(unknown, start_2)})) << cuts;
    }
}

TEST(fc_reader, takes_stx_inside_a_telegram_for_data)
{
    // ADR 2, PCD full of STX, and BCC 2.
    for (auto const& data : {byte_list{0x02, 0x02, 0x02, 0x02}, byte_list{0x02, 0x06, 0x02, 0x06},
                             byte_list{0x00, 0x02, 0x00, 0x06}, byte_list(12, 0x02), byte_list(200, 0x02)}) {
        for (int const adr : {0x01, 0x02}) {
            auto const whole = telegram_of(adr, data);
            EXPECT_EQ(read(line_of(whole)).size(), 1U);
            EXPECT_EQ(read(line_of(whole, whole, silence, whole, silence)).size(), 3U);
            for (auto const& i : read(line_of(whole, whole, silence, whole, silence))) { EXPECT_EQ(i.raw, whole); }
        }
    }
}

TEST(fc_reader, takes_a_telegram_that_holds_another_one_as_one)
{
    // The first eight characters of a display text are a telegram that starts the motor.
    auto const whole = fc::encode(fc::address::short_format(1),
                                  fc::write_text(533, "\x02\x06\x01\x04\x7F\x20\x00\x5E", fc::data_not_valid));
    EXPECT_EQ(read(line_of(whole)), (items{frame(unknown, whole)}));
    EXPECT_EQ(read(line_of(whole, whole, start, silence)),
              (items{frame(unknown, whole), frame(unknown, whole), frame(unknown, start)}));
}

TEST(fc_reader, takes_telegrams_of_every_length)
{
    for (std::size_t size = 4; size <= 252; ++size) {
        auto const whole = telegram_of(1, byte_list(size, 0xF2));
        EXPECT_EQ(read(line_of(whole, start_2, silence)), (items{frame(unknown, whole), frame(unknown, start_2)}))
            << size;
    }
}

//=== noise ===//

TEST(fc_reader, knows_an_lge_that_cannot_be_at_once)
{
    for (int const lge : {0, 1, 2, 3, 4, 5, 255}) {
        auto const noise = line_of(0x02, lge);
        EXPECT_EQ(read(line_of(noise, start)), (items{dropped(errc::bad_length, noise), frame(unknown, start, false)}))
            << lge;
        EXPECT_EQ(read(line_of(noise, silence, start)),
                  (items{dropped(errc::bad_length, noise), frame(unknown, start)}))
            << lge;
        fc::reader reader;  // what follows is not awaited
        EXPECT_TRUE(reader.push(stream_model::bytes_of(noise)).empty());
        reader.silence();
        EXPECT_EQ(reader.next().dropped()->reason, errc::bad_length);
    }
}

TEST(fc_reader, shows_what_another_layout_has)
{
    constexpr auto other = fc::basic_reader<fc::data_layout<4, 12>>{};
    EXPECT_EQ(read(line_of(start, silence), other), (items{frame(unknown, start)}));
}

TEST(fc_reader, waits_for_as_many_bytes_as_the_lge_of_noise_says_but_not_beyond_a_silence)
{
    for (int lge = 6; lge <= 254; ++lge) {
        auto const noise = line_of(0x02, lge);
        EXPECT_EQ(read(line_of(noise)), items{});
        EXPECT_EQ(read(line_of(noise, silence, start, silence)),
                  (items{dropped(errc::truncated, noise), frame(unknown, start)}));
        // Directly behind it, the telegram is looked at when the noise is refuted: here, by the silence or by its BCC.
        auto const said = read(line_of(noise, start_2, start, silence));
        ASSERT_EQ(said.size(), 3U) << lge;
        EXPECT_EQ(said[0], dropped(lge <= 16 ? errc::bad_checksum : errc::truncated, noise)) << lge;
        EXPECT_EQ(said[1], frame(unknown, start_2, false));
        EXPECT_EQ(said[2], frame(unknown, start));
    }
}

TEST(fc_reader, drops_half_a_telegram_at_the_silence)
{
    for (auto const& whole : {line_of(write_202), line_of(answer_text), line_of(start)}) {
        for (std::size_t size = 1; size < whole.size(); ++size) {
            line const half{whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)};
            EXPECT_EQ(read(line_of(half, silence)), (items{dropped(errc::truncated, half)}));
            EXPECT_EQ(read(line_of(half, silence, whole, silence)),
                      (items{dropped(errc::truncated, half),
                             frame(whole == line_of(write_202) ? request : unknown, stream_model::bytes_of(whole))}));
        }
    }
}

TEST(fc_reader, drops_the_other_half_of_a_telegram)
{
    for (std::size_t lost = 1; lost < write_202.size(); ++lost) {
        auto const half = bytes{write_202}.subspan(lost);
        EXPECT_EQ(read(line_of(half, silence, start)), (items{dropped(errc::bad_length, half), frame(unknown, start)}));
        EXPECT_EQ(read(line_of(half, start)), (items{dropped(errc::bad_length, half), frame(unknown, start, false)}));
    }
}

TEST(fc_reader, says_what_was_wrong_with_dropped_bytes)
{
    auto damaged = write_202;
    damaged[10] ^= 1;
    EXPECT_EQ(read(line_of(damaged, silence)), (items{dropped(errc::bad_checksum, damaged)}));
    EXPECT_EQ(read(line_of(bytes{write_202}.first(15), silence)),
              (items{dropped(errc::truncated, bytes{write_202}.first(15))}));
    EXPECT_EQ(read(line_of(0x55, 0xAA, silence)), (items{dropped(errc::bad_length, line_of(0x55, 0xAA))}));
}

TEST(fc_reader, refuses_every_single_wrong_bit)
{
    for (auto const& whole : {byte_list(write_202.begin(), write_202.end()), byte_list(start.begin(), start.end()),
                              byte_list(answer_text.begin(), answer_text.end())}) {
        for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
            auto damaged = whole;
            damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
            for (auto const& i : read(line_of(damaged, silence))) { EXPECT_FALSE(i.is_frame) << bit; }
        }
    }
}

TEST(fc_reader, gives_every_byte_of_hostile_streams_back_once)
{
    std::vector<byte_list> streams{byte_list(2000, 0x02)};
    for (unsigned byte = 0; byte < 256; ++byte) {
        streams.push_back(byte_list(300, static_cast<std::uint8_t>(byte)));
        streams.push_back({});
        for (int i = 0; i < 300; ++i) { streams.back().push_back(i % 2 == 0 ? 0x02 : static_cast<std::uint8_t>(byte)); }
    }
    for (auto const& stream : streams) { EXPECT_EQ(stream_model::bytes_of(read(line_of(stream, silence))), stream); }
    EXPECT_EQ(read(line_of(byte_list(100, 0x42), silence)),
              (items{dropped(errc::bad_length, byte_list(63, 0x42)), dropped(errc::bad_length, byte_list(37, 0x42))}));
}

//=== alignment ===//

/// Counts what a slave carries out.
struct counting_drive {
    unsigned* started;
    unsigned* written;

    fc::process_status operator()(fc::process_command const& asked) const
    {
        *started += asked.is_data_valid() ? 1U : 0U;
        return {};
    }
    fc::parameter_answer operator()(fc::parameter_request const&) const
    {
        ++*written;
        return fc::parameter_answer::value(std::uint16_t{1000});
    }
    fc::text_answer operator()(fc::text_request const&) const { return bytes{}; }
};

struct carried_out {
    unsigned started  = 0;
    unsigned written  = 0;
    unsigned answered = 0;

    friend bool operator==(carried_out const&, carried_out const&) = default;
};

/// What slave 1 does, with a reader of its own, when it hears this and then a silence.
carried_out slave_hears(auto const& heard, expecting what = expecting::either)
{
    carried_out                   done;
    std::array<std::uint8_t, 256> buffer{};
    fc::reader                    reader{what, fc::address::short_format(1)};
    EXPECT_TRUE(reader.push(heard).empty());
    reader.silence();
    while (auto const given = reader.next()) {
        auto const* found = given.frame();
        if (found == nullptr) { continue; }
        auto const reply =
            fc::serve(fc::address::short_format(1), *found, buffer, counting_drive{&done.started, &done.written});
        done.answered += reply.empty() ? 0U : 1U;
    }
    return done;
}

TEST(fc_reader, finds_the_telegram_inside_a_damaged_one_but_not_aligned_and_slaves_ignore_it)
{
    auto const whole = fc::encode(fc::address::short_format(1),
                                  fc::write_text(533, "\x02\x06\x01\x04\x7F\x20\x00\x5E", fc::data_not_valid));
    auto       cut   = whole;
    cut[19] ^= 0x01;  // BCC
    auto const outer = bytes{cut};
    EXPECT_EQ(read(line_of(cut, silence)),
              (items{dropped(errc::bad_checksum, outer.first(7)), frame(unknown, start, false),
                     dropped(errc::bad_length, outer.last(5))}));

    for (auto const what : {expecting::either, expecting::request}) {
        EXPECT_EQ(slave_hears(start, what), (carried_out{.started = 1, .answered = 1}));
        EXPECT_EQ(slave_hears(cut, what), carried_out{});
        EXPECT_EQ(slave_hears(whole, what), (carried_out{.answered = 1}));
    }
    // Whichever bit is wrong, whatever is missing, and what was lost before it: nothing starts.
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        auto damaged = whole;
        damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        EXPECT_EQ(slave_hears(damaged), carried_out{}) << bit;
    }
    for (std::size_t lost = 1; lost < whole.size(); ++lost) {
        EXPECT_EQ(slave_hears(bytes{whole}.first(whole.size() - lost)), carried_out{}) << lost;
        if (lost != 7) { EXPECT_EQ(slave_hears(bytes{whole}.subspan(lost)), carried_out{}) << lost; }
    }
}

TEST(fc_reader, aligns_behind_a_silence_and_behind_a_valid_telegram)
{
    EXPECT_EQ(read(line_of(0x55, start, start, silence, start)),
              (items{dropped(errc::bad_length, line_of(0x55)), frame(unknown, start, false), frame(unknown, start),
                     frame(unknown, start)}));
    EXPECT_EQ(read(line_of(start, 0x55, start)),
              (items{frame(unknown, start), dropped(errc::bad_length, line_of(0x55)), frame(unknown, start, false)}));
    EXPECT_EQ(read(line_of(start, 0x55, silence, start)),
              (items{frame(unknown, start), dropped(errc::bad_length, line_of(0x55)), frame(unknown, start)}));
}

//=== requests and responses ===//

TEST(fc_reader, reads_what_follows_a_request_to_a_slave_as_its_response)
{
    EXPECT_EQ(
        read(line_of(write_202, silence, start, silence, start, silence, start, silence)),
        (items{frame(request, write_202), frame(response, start), frame(request, start), frame(response, start)}));
}

TEST(fc_reader, reads_a_request_to_another_slave_as_one_when_the_first_is_absent)
{
    EXPECT_EQ(read(line_of(write_202, silence, start_2, silence, start_2, silence)),
              (items{frame(request, write_202), frame(request, start_2), frame(response, start_2)}));
    // The other format is another address on the wire, for a slave sends ADR back unchanged.
    EXPECT_EQ(read(line_of(write_202, start_long_1)), (items{frame(request, write_202), frame(request, start_long_1)}));
}

TEST(fc_reader, expects_no_response_to_a_broadcast)
{
    EXPECT_EQ(read(line_of(start_all, start_all, start)),
              (items{frame(request, start_all), frame(request, start_all), frame(request, start)}));
}

TEST(fc_reader, forgets_a_request_that_timed_out)
{
    EXPECT_EQ(read(line_of(write_202, timeout, start, start)),
              (items{frame(request, write_202), frame(request, start), frame(response, start)}));
    EXPECT_EQ(read(line_of(write_202, silence, timeout, start, timeout, start, start)),
              (items{frame(request, write_202), frame(request, start), frame(request, start), frame(response, start)}));
    EXPECT_EQ(read(line_of(refusal, timeout, start)), (items{frame(response, refusal), frame(request, start)}));
}

TEST(fc_reader, knows_who_speaks_next_when_nobody_answered_for_long_enough)
{
    EXPECT_EQ(read(line_of(timeout, start, timeout, start)), (items{frame(request, start), frame(request, start)}));
    EXPECT_EQ(read(line_of(start, timeout, start, start)),
              (items{frame(unknown, start), frame(request, start), frame(response, start)}));
}

TEST(fc_reader, takes_a_telegram_for_a_request_if_the_time_out_comes_amid_it)
{
    EXPECT_EQ(read(line_of(write_202, bytes{start}.first(3), bytes{start}.subspan(3))),
              (items{frame(request, write_202), frame(response, start)}));
    EXPECT_EQ(read(line_of(write_202, bytes{start}.first(3), timeout, bytes{start}.subspan(3))),
              (items{frame(request, write_202), frame(request, start)}));
}

TEST(fc_reader, takes_a_telegram_for_a_request_that_was_found_before_the_time_out_and_not_yet_given)
{
    auto const raw = stream_model::bytes_of(line_of(write_202, 0x00, 0x00, start));
    fc::reader reader;
    EXPECT_TRUE(reader.push(raw).empty());
    ASSERT_NE(reader.next().frame(), nullptr);
    ASSERT_NE(reader.next().dropped(), nullptr);
    reader.request_timed_out();
    std::vector<item> said;
    stream_model::take_all(reader, kind_of, said);
    EXPECT_EQ(said, (items{frame(request, start, false)}));
}

TEST(fc_reader, finds_what_is_addressed_to_its_own_slave_to_be_requests)
{
    for (auto const& own : {fc::reader{expecting::either, fc::address::short_format(1)},
                            fc::reader{expecting::either, fc::address::long_format(1)}}) {
        EXPECT_EQ(read(line_of(start, start, start_long_1, refusal), own),
                  (items{frame(request, start), frame(request, start), frame(request, start_long_1),
                         frame(request, refusal)}));
        EXPECT_EQ(
            read(line_of(start_2, start, start_2, start_2), own),
            (items{frame(unknown, start_2), frame(request, start), frame(request, start_2), frame(response, start_2)}));
    }
}

TEST(fc_reader, finds_all_to_be_what_it_expects)
{
    EXPECT_EQ(
        read(line_of(start, refusal, write_202, start_all), fc::reader{expecting::request}),
        (items{frame(request, start), frame(request, refusal), frame(request, write_202), frame(request, start_all)}));
    EXPECT_EQ(read(line_of(start, refusal, write_202, start_all), fc::reader{expecting::response}),
              (items{frame(response, start), frame(response, refusal), frame(response, write_202),
                     frame(response, start_all)}));
}

TEST(fc_reader, a_slave_on_a_shared_line_answers_its_requests_and_not_its_neighbours_responses)
{
    auto const heard = stream_model::bytes_of(line_of(start_2, start_2, start, start_all));
    EXPECT_EQ(slave_hears(heard), (carried_out{.started = 2, .answered = 1}));
    auto const of_2 = telegram_of(2, bytes{refusal}.subspan(3, 12));
    EXPECT_EQ(slave_hears(of_2), carried_out{});
}

// Its responses have its own address, as its requests: the caller has to take out what it hears of itself.
TEST(fc_reader, a_slave_cannot_tell_the_echo_of_its_response_from_a_request)
{
    for (auto const what : {expecting::either, expecting::request}) {
        EXPECT_EQ(slave_hears(answer_206, what), (carried_out{.started = 1, .written = 1, .answered = 1}));
    }
}

//=== a noisy line ===//

/// Does a telegram with a right BCC begin in the first `noise` bytes? Plainly.
bool noise_forms_a_telegram(byte_list const& stream, std::size_t noise)
{
    for (std::size_t begin = 0; begin < noise; ++begin) {
        if (stream[begin] != 0x02 or begin + 1 >= stream.size()) { continue; }
        auto const size = std::size_t{stream[begin + 1]} + 2;
        if (size < 8 or size > 256 or size > stream.size() - begin) { continue; }
        if (fc_model::bcc(bytes{stream}.subspan(begin, size)) == 0) { return true; }
    }
    return false;
}

/// Process data, a parameter or a text, of any slave, to it or from it.
byte_list any_telegram(dice& random)
{
    auto const adr = static_cast<int>(random.one_in(2) ? 1 + random.below(31) : 0x81 + random.below(126));
    switch (random.below(3)) {
    case 0: return telegram_of(adr, random.noise(4));
    case 1: return telegram_of(adr, random.noise(12));
    default: {
        auto data = random.noise(8 + random.below(21));
        data[0]   = static_cast<std::uint8_t>(0xF0 | data[0] % 16);
        return telegram_of(adr, data);
    }
    }
}

struct recovery {
    unsigned tried     = 0;
    unsigned exempt    = 0;  // the noise forms a telegram
    unsigned missing   = 0;  // of the others
    unsigned unaligned = 0;  // of the others, the first telegram
};

/// After noise, and a silence if there is one, two telegrams with no pause, then a silence: are both found?
recovery recover(unsigned seed, bool is_silent, auto make_noise)
{
    recovery result;
    dice     random{seed};
    for (unsigned trial = 0; trial < trials; ++trial) {
        byte_list const noise  = make_noise(random);
        auto const      first  = any_telegram(random);
        auto const      second = any_telegram(random);
        auto const      heard =
            is_silent ? line_of(noise, silence, first, second, silence) : line_of(noise, first, second, silence);
        auto const joined = is_silent ? noise : stream_model::bytes_of(heard);

        fc::reader whole;
        auto const said = read(whole, heard);
        fc::reader chunked;
        if (read(chunked, heard, all_ways[1 + trial % 3], trial) != said or not(chunked.counters() == whole.counters())
            or stream_model::bytes_of(said) != stream_model::bytes_of(heard)) {
            ADD_FAILURE() << "chunks change what is said of " << stream_model::to_text(heard);
        }
        ++result.tried;
        auto const forms_one = noise_forms_a_telegram(joined, noise.size());
        result.exempt += forms_one ? 1U : 0U;
        if (not is_silent and forms_one) { continue; }

        // They are the last ones; behind a silence, whatever was made of the noise.
        auto const count = said.size();
        auto const found = count >= 2 and said[count - 2].is_frame and said[count - 2].raw == first
                           and said[count - 1].is_frame and said[count - 1].raw == second and said[count - 1].aligned;
        if (not found) {
            ++result.missing;
            ADD_FAILURE() << "not both found: " << stream_model::to_text(heard);
            continue;
        }
        result.unaligned += said[count - 2].aligned ? 0U : 1U;
        // No telegram was made of noise that forms none.
        auto const frames = std::count_if(said.begin(), said.end(), [](item const& i) { return i.is_frame; });
        EXPECT_EQ(frames > 2, forms_one) << stream_model::to_text(heard);
    }
    return result;
}

class fc_reader_after_noise : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(of, fc_reader_after_noise, testing::Values(1, 3, 8, 64), testing::PrintToStringParamName());

TEST_P(fc_reader_after_noise, finds_two_telegrams_behind_a_silence_in_every_trial)
{
    auto const size   = GetParam();
    auto const seed   = static_cast<unsigned>(2024 + size);
    auto const result = recover(seed, true, [size](dice& random) { return random.noise(size); });
    std::printf(
        "%u noise bytes and a silence, seed %u: both telegrams found in %u of %u trials; in %u the noise forms one\n",
        static_cast<unsigned>(size), seed, result.tried - result.missing, result.tried, result.exempt);
    EXPECT_EQ(result.tried, trials);
    EXPECT_EQ(result.missing, 0U);  // not even where the noise forms one
    EXPECT_EQ(result.unaligned, 0U);
    EXPECT_LE(result.exempt, size < 8 ? 0U : 10U);
}

TEST_P(fc_reader_after_noise, finds_two_telegrams_directly_behind_it_in_every_trial)
{
    auto const size   = GetParam();
    auto const seed   = static_cast<unsigned>(3024 + size);
    auto const result = recover(seed, false, [size](dice& random) { return random.noise(size); });
    std::printf("%u noise bytes, seed %u: both telegrams found in %u of %u trials; in %u the noise forms one\n",
                static_cast<unsigned>(size), seed, result.tried - result.exempt - result.missing, result.tried,
                result.exempt);
    EXPECT_EQ(result.tried, trials);
    EXPECT_EQ(result.missing, 0U);
    EXPECT_LE(result.exempt, 20U);
}

TEST(fc_reader, finds_two_telegrams_after_half_a_telegram_and_a_silence)
{
    auto const result = recover(11, true, [](dice& random) {
        auto half = any_telegram(random);
        half.resize(random.below(half.size()));
        return half;
    });
    EXPECT_EQ(result.missing + result.unaligned, 0U);
    EXPECT_LE(result.exempt, 10U);
}

TEST(fc_reader, finds_two_telegrams_after_a_broken_one)
{
    auto const broken = [](dice& random) {
        auto whole = any_telegram(random);
        whole.back() ^= static_cast<std::uint8_t>(1 + random.below(255));
        return whole;
    };
    for (auto const is_silent : {false, true}) {
        auto const result = recover(12, is_silent, broken);
        EXPECT_EQ(result.missing, 0U);
        EXPECT_LE(result.exempt, 20U);
    }
}

//=== against the rule, written a second time ===//

using fc_model::listens_for;

template <typename Rules = fc_model::rules, typename Reader>
void compare_with_the_rule(Reader const& fresh, Rules rules, unsigned seeds, unsigned first_seed,
                           std::size_t process_words = 2)
{
    for (unsigned seed = first_seed; seed < first_seed + seeds; ++seed) {
        dice                          random{seed};
        auto const                    heard = fc_model::random_line(random, process_words);
        stream_model::decision<Rules> decide{rules, Reader::max_run};
        auto const                    expected = decide(heard);
        for (auto const how : {way::in_one_chunk, all_ways[1 + seed % 3]}) {
            auto reader = fresh;
            ASSERT_EQ(read(reader, heard, how, seed), expected)
                << "seed " << seed << ", way " << static_cast<int>(how) << ": " << stream_model::to_text(heard);
            ASSERT_EQ(reader.counters(), stream_model::counters_of<stream_counters>(expected)) << seed;
        }
        ASSERT_EQ(stream_model::bytes_of(expected), stream_model::bytes_of(heard)) << seed;
    }
}

TEST(fc_reader, decides_as_the_rule_says_on_random_traffic)
{
    compare_with_the_rule(fc::reader{}, fc_model::rules{}, trials / 2, 1);
}

TEST(fc_reader, decides_as_the_rule_says_with_its_own_address)
{
    compare_with_the_rule(fc::reader{expecting::either, fc::address::short_format(1)},
                          fc_model::rules{.to = listens_for::either, .own_number = 1}, trials / 5, 10'001);
    compare_with_the_rule(fc::reader{expecting::either, fc::address::long_format(2)},
                          fc_model::rules{.to = listens_for::either, .own_number = 2}, trials / 5, 20'001);
}

TEST(fc_reader, decides_as_the_rule_says_when_it_expects_one_direction)
{
    compare_with_the_rule(fc::reader{expecting::request}, fc_model::rules{.to = listens_for::requests}, trials / 10,
                          30'001);
    compare_with_the_rule(fc::reader{expecting::response, fc::address::short_format(1)},
                          fc_model::rules{.to = listens_for::responses, .own_number = 1}, trials / 10, 40'001);
}

TEST(fc_reader, decides_as_the_rule_says_with_other_layouts)
{
    compare_with_the_rule(fc::basic_reader<fc::fc_layout>{}, fc_model::rules_of<2, 12>{}, trials / 10, 50'001);
    compare_with_the_rule(fc::basic_reader<fc::data_layout<4, 12>>{}, fc_model::rules_of<4, 12>{}, trials / 10, 60'001,
                          4);
    compare_with_the_rule(fc::basic_reader<fc::data_layout<16, 11>>{}, fc_model::rules_of<16, 11>{}, trials / 10,
                          70'001, 16);
}

template <std::size_t Capacity>
using reader_of = fc::basic_reader<fc::vlt_layout, Capacity>;

TEST(fc_reader, decides_as_the_rule_says_with_any_capacity)
{
    compare_with_the_rule(reader_of<258>{}, fc_model::rules{}, trials / 20, 80'001);
    compare_with_the_rule(reader_of<259>{}, fc_model::rules{}, trials / 40, 81'001);
    compare_with_the_rule(reader_of<600>{}, fc_model::rules{}, trials / 40, 82'001);
    compare_with_the_rule(reader_of<5000>{}, fc_model::rules{}, trials / 40, 83'001);
}

TEST(fc_reader, decides_as_the_rule_says_on_noise)
{
    for (unsigned seed = 1; seed <= trials / 50; ++seed) {
        dice       random{seed};
        auto const few = [&random](std::size_t size) {  // many beginnings
            auto made = random.noise(size);
            for (auto& byte : made) { byte = std::array<std::uint8_t, 5>{0x02, 0x06, 0x0E, 0x02, 0x20}[byte % 5]; }
            return made;
        };
        auto const heard = line_of(seed % 3 == 0 ? few(600) : random.noise(600), seed % 2 == 0 ? silence : timeout,
                                   seed % 3 == 1 ? few(400) : random.noise(400), silence);
        stream_model::decision<fc_model::rules> decide{{}, fc::reader::max_run};
        auto const                              expected = decide(heard);
        for (auto const how : all_ways) {
            fc::reader reader;
            ASSERT_EQ(read(reader, heard, how, seed), expected) << seed;
        }
    }
}

//=== there and back ===//

template <typename Process, typename Layout>
Process random_process(dice& random)
{
    return Process::read(random.noise(Layout::process_size));
}

/// Telegrams that were sent one behind the other, and what each of them has to be again.
struct traffic {
    template <typename Layout, typename Data>
    void send(fc::address to, Data const& data, fc::data_kind kind)
    {
        std::array<std::uint8_t, 256> buffer{};
        auto const                    whole = fc::encode(to, data, buffer);
        ASSERT_TRUE(whole);
        stream.insert(stream.end(), whole->begin(), whole->end());
        is_again.emplace_back([=](fc::frame const& found) {
            auto const decoded = fc::decode<Data>(found.raw);
            return found.aligned and found.template kind<Layout>() == kind and decoded and decoded->address == to
                   and decoded->data == data;
        });
    }

    byte_list                                          stream{};
    std::vector<std::function<bool(fc::frame const&)>> is_again{};
};

/// Sends telegrams of every kind in random chunks; what comes out of the reader decodes to what was encoded.
template <typename Layout>
void send_and_receive(unsigned seed)
{
    using command = fc::basic_process_command<Layout>;
    using status  = fc::basic_process_status<Layout>;
    dice       random{seed};
    traffic    sent;
    auto const texts = random.noise(fc::max_text_size<Layout>);
    for (int i = 0; i < 20; ++i) {
        auto const format = random.one_in(2) ? fc::address_format::short_1_to_31 : fc::address_format::long_1_to_126;
        auto const to     = *fc::address::make(format, static_cast<std::uint8_t>(1 + random.below(31)));
        auto const pke    = fc::pke::from_raw(static_cast<std::uint16_t>(random.below(0xF000)));  // F is a text
        auto const ind    = fc::ind::from_raw(static_cast<std::uint16_t>(random.below(0x10000)));
        auto const pwe    = static_cast<std::uint32_t>(random.below(0x10000) << 16 | random.below(0x10000));
        auto const text   = pke.with(fc::pke::reply, fc::ak_reply::text);
        auto const part   = bytes{texts}.first(random.below(texts.size() + 1));
        auto const asked  = random_process<command, Layout>(random);
        auto const said   = random_process<status, Layout>(random);
        switch (random.below(6)) {
        case 0: sent.send<Layout>(to, asked, fc::data_kind::process); break;
        case 1: sent.send<Layout>(to, said, fc::data_kind::process); break;
        case 2:
            sent.send<Layout>(to, fc::basic_parameter_request<Layout>{pke, ind, pwe, asked}, fc::data_kind::parameter);
            break;
        case 3:
            sent.send<Layout>(to, fc::basic_parameter_response<Layout>{pke, ind, pwe, said}, fc::data_kind::parameter);
            break;
        case 4:
            sent.send<Layout>(to, fc::basic_text_request<Layout>{text, ind, part, asked}, fc::data_kind::text);
            break;
        default: sent.send<Layout>(to, fc::basic_text_response<Layout>{text, ind, part, said}, fc::data_kind::text);
        }
    }

    fc::basic_reader<Layout> reader;
    std::size_t              at = 0;
    for (bytes rest{sent.stream}; not rest.empty();) {
        auto const size = std::min(std::size_t{1 + random.below(random.one_in(2) ? 4 : 300)}, rest.size());
        rest            = rest.subspan(size - reader.push(rest.first(size)).size());
        while (auto const given = reader.next()) {
            ASSERT_TRUE(given.frame() != nullptr and at < sent.is_again.size());
            ASSERT_TRUE(sent.is_again[at](*given.frame())) << at;
            ++at;
        }
    }
    ASSERT_EQ(at, sent.is_again.size());
}

TEST(fc_reader, gives_telegrams_of_every_kind_back_however_they_are_chunked)
{
    for (unsigned seed = 1; seed <= trials / 40; ++seed) {
        ASSERT_NO_FATAL_FAILURE(send_and_receive<fc::vlt_layout>(seed)) << seed;
        ASSERT_NO_FATAL_FAILURE(send_and_receive<fc::fc_layout>(seed)) << seed;
        ASSERT_NO_FATAL_FAILURE((send_and_receive<fc::data_layout<4, 12>>(seed))) << seed;
    }
}

//=== work ===//

/// Counts the bytes that checksums cover.
struct counting_framing : fc::framing<> {
    static inline std::size_t checksums = 0;
    static inline std::size_t covered   = 0;

    [[nodiscard]] static bool is_intact(bytes telegram) noexcept
    {
        ++checksums;
        covered += telegram.size();
        return fc::framing<>::is_intact(telegram);
    }
};

TEST(fc_reader, does_a_bounded_amount_of_work_for_each_byte)
{
    constexpr std::size_t  size = 4000;
    std::vector<byte_list> streams;
    for (auto const& pattern : {byte_list{0x02}, byte_list{0x02, 0xFE}, byte_list{0x02, 0x06},
                                byte_list{0x02, 0x02, 0xFE}, byte_list{0xFE, 0xFE, 0x02}, byte_list{0x00}}) {
        byte_list stream;
        for (std::size_t i = 0; i < size; ++i) { stream.push_back(pattern[i % pattern.size()]); }
        streams.push_back(stream);
    }
    for (auto const& stream : streams) {
        for (auto const how : all_ways) {
            drivecodec::deframer<counting_framing> reader;
            counting_framing::checksums = 0;
            counting_framing::covered   = 0;
            EXPECT_EQ(stream_model::bytes_of(read(reader, line_of(stream, silence), how)), stream);
            EXPECT_LE(counting_framing::checksums, stream.size());
            EXPECT_LE(counting_framing::covered, stream.size() * fc::max_telegram_size);
        }
    }
}

//=== buffers ===//

TEST(fc_reader, keeps_what_it_gave_until_the_next_call)
{
    fc::reader reader;
    auto const raw = stream_model::bytes_of(line_of(0xFF, write_202, answer_202));
    EXPECT_TRUE(reader.push(raw).empty());
    std::size_t at = 0;
    while (auto const given = reader.next()) {
        auto const view = given.frame() != nullptr ? given.frame()->raw : given.dropped()->raw;
        static_cast<void>(reader.counters());
        static_cast<void>(reader.scheme());
        ASSERT_TRUE(std::equal(view.begin(), view.end(), raw.begin() + static_cast<std::ptrdiff_t>(at)));
        at += view.size();
    }
    EXPECT_EQ(at, raw.size());
}

TEST(fc_reader, takes_no_more_bytes_than_it_has_room_for)
{
    fc::reader      reader;
    byte_list const many(1000, 0x02);
    auto const      rest = reader.push(many);
    EXPECT_EQ(rest.size(), 1000 - (fc::max_telegram_size + 64));
    EXPECT_EQ(reader.push(rest).size(), rest.size());
}

TEST(fc_reader, gives_nothing_of_a_silent_line)
{
    fc::reader reader;
    for (int i = 0; i < 3; ++i) {
        reader.silence();
        EXPECT_FALSE(reader.next());
    }
    EXPECT_EQ(reader.counters(), stream_counters{});
}

//=== in a constant expression ===//

TEST(fc_reader, works_in_constant_expressions)
{
    VERIFY([] {
        fc::reader reader;
        auto const noise = "FF 02 05"_hex;
        if (not reader.push(noise).empty() or not reader.push(write_202).empty()) { return false; }
        auto const run = reader.next();
        if (run.dropped() == nullptr or not same_bytes(run.dropped()->raw, noise)) { return false; }
        auto const found = reader.next();
        return found.frame() != nullptr and same_bytes(found.frame()->raw, write_202)
               and found.frame()->address() == fc::address::short_format(1)
               and found.frame()->kind() == fc::data_kind::parameter
               and found.frame()->direction == fc::direction::request and not found.frame()->aligned
               and not reader.next()
               and reader.counters()
                       == stream_counters{.frames = 1, .unaligned_frames = 1, .dropped_runs = 1, .dropped_bytes = 3};
    }());
    static_assert([] {
        fc::reader reader{expecting::response};
        for (auto const byte : answer_text) {
            auto const room = reader.prepare();
            room[0]         = byte;
            reader.commit(1);
        }
        auto const found = reader.next();
        return found.frame() != nullptr and found.frame()->aligned and found.frame()->kind() == fc::data_kind::text;
    }());
}

}  // namespace
