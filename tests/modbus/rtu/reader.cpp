#include <drivecodec/modbus/rtu/reader.hpp>

#include "support/hex.hpp"
#include "support/rtu_model.hpp"
#include "support/verify.hpp"

#include <drivecodec/modbus/rtu/server.hpp>

namespace {

namespace modbus = drivecodec::modbus;
namespace rtu    = drivecodec::modbus::rtu;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::same_bytes;
using drivecodec::stream_counters;
using rtu::expecting;
using rtu_model::adu_of;
using rtu_model::byte_list;
using rtu_model::dice;
using rtu_model::request;
using rtu_model::response;
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

constexpr auto kind_of = [](rtu::frame const& f) {
    return f.direction == modbus::direction::request ? request : response;
};

template <typename Reader>
std::vector<item> read(Reader& reader, line const& heard, way how = way::in_one_chunk, unsigned seed = 1)
{
    return stream_model::read(reader, heard, how, kind_of, seed);
}

/// What a new reader says of `heard`, after it was found to say the same however the bytes come.
std::vector<item> read(line const& heard, rtu::reader const& fresh = rtu::reader{})
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

//=== the sequences of the design ===//

constexpr auto frame_within_a_frame = "05 03 08 01 06 00 00 00 01 48 0A C0 EC"_hex;
constexpr auto write_within         = "01 06 00 00 00 01 48 0A"_hex;
constexpr auto asks_for_too_much    = "01 03 00 00 00 7E C5 EA"_hex;
constexpr auto write_like_response  = "01 10 10 04 00 02 04 C9 12 34 56 36 FB"_hex;
constexpr auto like_request         = "01 03 04 00 00 01 85 3A 00"_hex;
constexpr auto read_two             = "01 03 00 00 00 02 C4 0B"_hex;

TEST(rtu_reader, takes_a_frame_that_holds_another_one_as_one)
{
    EXPECT_EQ(read(line_of(frame_within_a_frame, silence)), (items{frame(response, frame_within_a_frame)}));
    EXPECT_EQ(read(line_of(frame_within_a_frame, silence), rtu::reader{expecting::response}),
              (items{frame(response, frame_within_a_frame)}));
}

TEST(rtu_reader, finds_the_frame_inside_a_damaged_one_but_not_aligned)
{
    auto damaged = frame_within_a_frame;
    damaged[11] ^= 0x10;
    auto const outer = bytes{damaged};
    auto const said  = read(line_of(damaged, silence));
    ASSERT_EQ(said, (items{dropped(errc::bad_checksum, outer.first(3)), frame(request, write_within, false),
                           dropped(errc::truncated, outer.last(2))}));

    // So the server to which it is addressed stays silent, and the same bytes alone on the line are carried out.
    unsigned   written = 0;
    auto const handler = [&written](modbus::write_single_register::request const&) {
        ++written;
        return modbus::done{};
    };
    std::array<std::uint8_t, 256> buffer{};
    rtu::reader                   reader{expecting::either, 1};
    EXPECT_TRUE(reader.push(damaged).empty());
    reader.silence();
    while (auto const given = reader.next()) {
        if (auto const* found = given.frame()) { EXPECT_TRUE(rtu::serve(1, *found, buffer, handler).empty()); }
    }
    EXPECT_EQ(written, 0U);

    EXPECT_TRUE(reader.push(write_within).empty());
    auto const alone = reader.next();
    ASSERT_TRUE(alone.frame() != nullptr and alone.frame()->aligned);
    auto const reply = rtu::serve(1, *alone.frame(), buffer, handler);
    EXPECT_EQ(byte_list(reply.begin(), reply.end()), byte_list(write_within.begin(), write_within.end()));
    EXPECT_EQ(written, 1U);
}

TEST(rtu_reader, gives_a_request_for_too_much_to_the_server_which_refuses_it)
{
    for (auto const what : {expecting::either, expecting::request}) {
        EXPECT_EQ(read(line_of(asks_for_too_much), rtu::reader{what}), (items{frame(request, asks_for_too_much)}));
    }
    rtu::reader reader;
    EXPECT_TRUE(reader.push(asks_for_too_much).empty());
    auto const given = reader.next();
    ASSERT_NE(given.frame(), nullptr);

    std::array<std::uint8_t, 256> buffer{};
    auto const                    handler = [](modbus::read_holding_registers::request const&) {
        ADD_FAILURE() << "the handler was asked";
        return modbus::exception_code::acknowledge;
    };
    auto const reply   = rtu::serve(1, *given.frame(), buffer, handler);
    auto const refusal = adu_of(1, "83 03"_hex);
    EXPECT_EQ(byte_list(reply.begin(), reply.end()), refusal);
}

TEST(rtu_reader, takes_a_write_that_begins_like_a_response_as_one_however_it_is_chunked)
{
    constexpr auto size = write_like_response.size();
    for (unsigned cuts = 0; cuts < 1U << (size - 1); ++cuts) {  // all ways to cut it
        rtu::reader       reader;
        std::vector<item> said;
        std::size_t       begin = 0;
        for (std::size_t end = 1; end <= size; ++end) {
            if (end < size and (cuts >> (end - 1) & 1U) == 0) { continue; }
            ASSERT_TRUE(reader.push(bytes{write_like_response}.subspan(begin, end - begin)).empty());
            stream_model::take_all(reader, kind_of, said);
            begin = end;
        }
        ASSERT_EQ(said, (items{frame(request, write_like_response)})) << cuts;
    }
}

TEST(rtu_reader, takes_the_response_inside_that_write_if_nothing_follows)
{
    auto const front = bytes{write_like_response}.first(8);
    EXPECT_EQ(read(line_of(front)), items{});
    EXPECT_EQ(read(line_of(front, silence)), (items{frame(response, front)}));
}

TEST(rtu_reader, reads_the_bytes_behind_a_request_as_its_response)
{
    EXPECT_EQ(read(line_of(read_two, silence, like_request, silence)),
              (items{frame(request, read_two), frame(response, like_request)}));
    EXPECT_EQ(read(line_of(read_two, like_request)), (items{frame(request, read_two), frame(response, like_request)}));
}

TEST(rtu_reader, reads_the_same_bytes_without_the_request_as_a_request_and_a_stray_byte)
{
    auto const whole = bytes{like_request};
    EXPECT_EQ(read(line_of(like_request, silence)),
              (items{frame(request, whole.first(8)), dropped(errc::truncated, whole.last(1))}));
    EXPECT_EQ(read(line_of(read_two, timeout, like_request, silence)),
              (items{frame(request, read_two), frame(request, whole.first(8)), dropped(errc::truncated, whole.last(1))}));
}

//=== requests and responses ===//

constexpr auto other_server  = "02 03 00 00 00 02 C4 38"_hex;
constexpr auto other_request = "01 04 00 00 00 02 71 CB"_hex;

TEST(rtu_reader, reads_a_second_request_as_one_when_the_server_is_absent)
{
    EXPECT_EQ(read(line_of(read_two, silence, other_server, silence)),
              (items{frame(request, read_two), frame(request, other_server)}));
    EXPECT_EQ(read(line_of(read_two, other_request)), (items{frame(request, read_two), frame(request, other_request)}));
    // The same again could be the beginning of a response without data, and is not.
    EXPECT_EQ(read(line_of(read_two, silence, read_two, silence)),
              (items{frame(request, read_two), frame(request, read_two)}));
}

TEST(rtu_reader, reads_an_echoing_function_alternately)
{
    EXPECT_EQ(read(line_of(write_within, write_within, write_within, write_within)),
              (items{frame(request, write_within), frame(response, write_within), frame(request, write_within),
                     frame(response, write_within)}));
}

TEST(rtu_reader, forgets_a_request_that_timed_out)
{
    EXPECT_EQ(read(line_of(write_within, timeout, write_within, write_within)),
              (items{frame(request, write_within), frame(request, write_within), frame(response, write_within)}));
}

TEST(rtu_reader, judges_waiting_bytes_anew_when_a_request_times_out)
{
    // 0C bytes are announced to a response; as a request the same bytes are whole.
    auto const again = adu_of(1, "03 0C 00 00 02"_hex);
    EXPECT_EQ(read(line_of(read_two, again)), (items{frame(request, read_two)}));
    EXPECT_EQ(read(line_of(read_two, again, timeout)), (items{frame(request, read_two), frame(request, again)}));
}

TEST(rtu_reader, judges_a_frame_anew_that_was_found_before_the_time_out_and_not_yet_given)
{
    auto const  answer = adu_of(1, "03 04 00 01 00 02"_hex);
    auto const  raw    = stream_model::bytes_of(line_of(read_two, 0x00, 0x00, answer));
    rtu::reader reader;
    EXPECT_TRUE(reader.push(raw).empty());
    reader.silence();
    ASSERT_NE(reader.next().frame(), nullptr);
    auto const run = reader.next();
    ASSERT_NE(run.dropped(), nullptr);
    ASSERT_EQ(run.dropped()->raw.size(), 2U);
    reader.request_timed_out();
    std::vector<item> said;
    stream_model::take_all(reader, kind_of, said);
    EXPECT_EQ(said, (items{frame(response, answer, false)}));
}

TEST(rtu_reader, expects_no_response_to_a_broadcast)
{
    auto const broadcast = adu_of(0, "06 00 01 00 02"_hex);
    EXPECT_EQ(read(line_of(broadcast, broadcast)), (items{frame(request, broadcast), frame(request, broadcast)}));
}

TEST(rtu_reader, expects_no_response_to_force_listen_only_mode)
{
    auto const command = adu_of(1, "08 00 04 00 00"_hex);
    EXPECT_EQ(read(line_of(command, command)), (items{frame(request, command), frame(request, command)}));
    auto const restart = adu_of(1, "08 00 01 00 00"_hex);
    EXPECT_EQ(read(line_of(restart, restart)), (items{frame(request, restart), frame(response, restart)}));
}

TEST(rtu_reader, expects_a_response_of_that_server_and_that_function_only)
{
    auto const write_to_2 = adu_of(2, "06 00 00 00 01"_hex);
    EXPECT_EQ(read(line_of(write_within, write_to_2)), (items{frame(request, write_within), frame(request, write_to_2)}));
    auto const coil = adu_of(1, "05 00 00 FF 00"_hex);
    EXPECT_EQ(read(line_of(write_within, coil)), (items{frame(request, write_within), frame(request, coil)}));
}

TEST(rtu_reader, takes_an_exception_for_the_response)
{
    auto const refusal = adu_of(1, "86 02"_hex);
    EXPECT_EQ(read(line_of(write_within, refusal, write_within)),
              (items{frame(request, write_within), frame(response, refusal), frame(request, write_within)}));
    EXPECT_EQ(read(line_of(refusal)), (items{frame(response, refusal)}));
}

TEST(rtu_reader, finds_what_is_addressed_to_its_own_server_to_be_requests)
{
    rtu::reader const own{expecting::either, 1};
    EXPECT_EQ(read(line_of(write_within, write_within), own), (items{frame(request, write_within), frame(request, write_within)}));
    auto const other = adu_of(2, "06 00 00 00 01"_hex);
    EXPECT_EQ(read(line_of(other, other), own), (items{frame(request, other), frame(response, other)}));
    // A response with its own address is no frame at all.
    auto const answer = adu_of(1, "03 02 00 07"_hex);
    EXPECT_EQ(read(line_of(answer, silence), own), (items{dropped(errc::truncated, answer)}));
}

TEST(rtu_reader, hears_only_what_it_expects)
{
    auto const answer = adu_of(1, "03 04 00 01 00 02"_hex);
    EXPECT_EQ(read(line_of(read_two, silence, answer, silence), rtu::reader{expecting::request}),
              (items{frame(request, read_two), dropped(errc::bad_checksum, answer)}));
    EXPECT_EQ(read(line_of(read_two, silence, answer, silence), rtu::reader{expecting::response}),
              (items{dropped(errc::bad_checksum, read_two), frame(response, answer)}));
    EXPECT_EQ(read(line_of(read_two, silence, answer, silence), rtu::reader{expecting::either}),
              (items{frame(request, read_two), frame(response, answer)}));
}

//=== frames that end with a silence ===//

TEST(rtu_reader, ends_frames_without_a_length_at_the_silence)
{
    for (auto const& pdu : {byte_list{0x42, 1, 2, 3}, byte_list{0x65}, byte_list{0x08, 0, 0, 0xA5, 0x37},
                            byte_list{0x08, 0, 0}, byte_list{0x08, 0, 0, 1, 2, 3, 4, 5, 6}, byte_list{0x08, 0x12, 0x34, 1, 2},
                            byte_list{0x08, 0, 19, 0, 0}, byte_list{0x2B, 0x0D, 1, 2, 3}, byte_list{0x2B, 0x0D},
                            byte_list{0x2B, 0x55, 7}}) {
        auto const whole = adu_of(9, pdu);
        EXPECT_EQ(read(line_of(whole)), items{});
        EXPECT_EQ(read(line_of(whole, silence)), (items{frame(request, whole)}));
        EXPECT_EQ(read(line_of(write_within, whole, silence)), (items{frame(request, write_within), frame(request, whole)}));
        EXPECT_EQ(read(line_of(whole, silence, whole, silence)), (items{frame(request, whole), frame(response, whole)}));

        auto damaged = whole;
        damaged[0] ^= 1;
        auto const said = read(line_of(damaged, silence, whole, silence));
        ASSERT_FALSE(said.empty());
        EXPECT_EQ(said.back(), frame(request, whole));
        for (auto i = said.begin(); i + 1 != said.end(); ++i) { EXPECT_FALSE(i->is_frame and i->aligned); }
    }
}

TEST(rtu_reader, does_not_end_frames_at_the_silence_that_are_not_aligned)
{
    auto const whole = adu_of(9, "42 01 02 03"_hex);
    EXPECT_EQ(read(line_of(0xFF, 0xFF, whole, silence)), (items{dropped(errc::bad_checksum, line_of(0xFF, 0xFF, whole))}));
}

TEST(rtu_reader, takes_frames_without_a_length_up_to_256_bytes)
{
    auto pdu = byte_list(253, 0x11);
    pdu[0]   = 0x42;
    auto const longest = adu_of(7, pdu);
    ASSERT_EQ(longest.size(), 256U);
    EXPECT_EQ(read(line_of(longest, silence)), (items{frame(request, longest)}));

    pdu.push_back(0x11);
    auto const too_long = adu_of(7, pdu);
    rtu::basic_reader<modbus::public_functions, modbus::crc16::by_default, 1024> reader;
    auto const                                                                   said = read(reader, line_of(too_long, silence));
    EXPECT_EQ(stream_model::bytes_of(said), too_long);
    for (auto const& i : said) { EXPECT_FALSE(i.is_frame and i.aligned); }
    ASSERT_FALSE(said.empty());
    EXPECT_FALSE(said.front().is_frame);
}

TEST(rtu_reader, reads_a_refusal_of_function_43_with_and_without_the_mei_type)
{
    auto const asked  = adu_of(1, "2B 0E 01 00"_hex);
    auto const short_ = adu_of(1, "AB 02"_hex);
    auto const long_  = adu_of(1, "AB 0E 02"_hex);
    for (auto const& refusal : {short_, long_}) {
        EXPECT_EQ(read(line_of(asked, refusal)), (items{frame(request, asked), frame(response, refusal)}));
        EXPECT_EQ(read(line_of(refusal)), (items{frame(response, refusal)}));
        EXPECT_EQ(read(line_of(refusal), rtu::reader{expecting::response}), (items{frame(response, refusal)}));
        EXPECT_EQ(read(line_of(asked, refusal, asked)),
                  (items{frame(request, asked), frame(response, refusal), frame(request, asked)}));
    }
    auto const other = adu_of(1, "AC 0E 02"_hex);
    EXPECT_EQ(read(line_of(other, silence)).front().is_frame, false);
}

//=== a noisy line ===//

TEST(rtu_reader, says_what_was_wrong_with_dropped_bytes)
{
    auto damaged = read_two;
    damaged[4] ^= 1;
    EXPECT_EQ(read(line_of(damaged, silence)), (items{dropped(errc::bad_checksum, damaged)}));
    EXPECT_EQ(read(line_of(bytes{read_two}.first(7), silence)),
              (items{dropped(errc::truncated, bytes{read_two}.first(7))}));
    // Functions in no set, amid dropped bytes: no frame begins so.
    EXPECT_EQ(read(line_of(0xFF, 0x66, 0x66, 0x66, 0x66, silence)),
              (items{dropped(errc::bad_checksum, line_of(0xFF, 0x66, 0x66, 0x66, 0x66))}));
    EXPECT_EQ(read(line_of(adu_of(1, "18 12 34 56"_hex), silence)).front().reason, errc::bad_checksum);
}

TEST(rtu_reader, gives_every_byte_of_hostile_streams_back_once)
{
    std::vector<byte_list> streams{byte_list(300, 0x42), byte_list(300, 0x00), byte_list(300, 0xFF), byte_list(2000, 0x03)};
    for (unsigned byte = 0; byte < 256; ++byte) { streams.push_back(byte_list(300, static_cast<std::uint8_t>(byte))); }
    for (auto const& stream : streams) {
        auto const said = read(line_of(stream, silence));
        EXPECT_EQ(stream_model::bytes_of(said), stream);
    }
    EXPECT_EQ(read(line_of(byte_list(300, 0x42), silence)),
              (items{dropped(errc::bad_length, byte_list(63, 0x42)), dropped(errc::bad_length, byte_list(63, 0x42)),
                     dropped(errc::bad_length, byte_list(63, 0x42)), dropped(errc::bad_length, byte_list(63, 0x42)),
                     dropped(errc::bad_length, byte_list(48, 0x42))}));
}

/// Does a reading that begins in the first `noise` bytes have a right checksum? All frame lengths, plainly.
bool noise_forms_a_frame(byte_list const& stream, std::size_t noise)
{
    for (std::size_t begin = 0; begin < noise; ++begin) {
        auto const front = bytes{stream}.subspan(begin);
        auto       fits  = [&](rtu_model::reading r) {
            auto const size = r.says == rtu_model::what::until_silence and begin == 0 ? front.size() : r.size;
            return r.says != rtu_model::what::needs_more and r.says != rtu_model::what::impossible and size >= 4
                   and size <= 256 and size <= front.size() and rtu_model::is_intact(front.first(size));
        };
        if (fits(rtu_model::request_of(front)) or fits(rtu_model::response_of(front))
            or (front[1] == 0xAB and fits({response, rtu_model::what::has_size, 6}))) {
            return true;
        }
    }
    return false;
}

struct recovery {
    unsigned tried   = 0;
    unsigned exempt  = 0;  // the noise forms a frame
    unsigned missing = 0;
};

/// After `before`: noise, a request 03 and a request 06 with no pause, a silence: are both found?
recovery recover(unsigned seed, auto before, auto make_noise, auto between)
{
    recovery result;
    dice     random{seed};
    for (unsigned trial = 0; trial < trials; ++trial) {
        auto const earlier = before(random);
        auto       pdu_03 = random.noise(5);
        auto       pdu_06 = random.noise(5);
        auto const noise  = make_noise(random);
        auto const gap    = between(random);
        pdu_03[0]         = 0x03;
        pdu_06[0]         = 0x06;
        auto const servers = random.one_in(2) ? 2U : 247U;
        auto const first   = adu_of(static_cast<int>(1 + random.below(servers)), pdu_03);
        auto const second  = adu_of(static_cast<int>(1 + random.below(servers)), pdu_06);
        auto const heard   = line_of(earlier, noise, first, gap, second, silence);
        auto const judged  = stream_model::bytes_of(line_of(noise, first, gap, second));

        rtu::reader whole;
        auto const  said = read(whole, heard);
        rtu::reader chunked;
        auto const  how = all_ways[1 + trial % 3];
        if (read(chunked, heard, how, trial) != said or not(chunked.counters() == whole.counters())
            or stream_model::bytes_of(said) != stream_model::bytes_of(heard)) {
            ADD_FAILURE() << "chunks change what is said of " << stream_model::to_text(heard);
        }
        ++result.tried;
        if (noise_forms_a_frame(judged, noise.size())) {
            ++result.exempt;
            continue;
        }
        auto const found = [&said](byte_list const& wanted) {
            return std::any_of(said.begin(), said.end(), [&](item const& i) { return i.is_frame and i.raw == wanted; });
        };
        if (not found(first) or not found(second)) {
            ++result.missing;
            ADD_FAILURE() << "not both found: " << stream_model::to_text(heard);
        }
    }
    return result;
}

byte_list nothing(dice&) { return {}; }
byte_list zero(dice&) { return {0}; }

class rtu_reader_after_noise : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(of, rtu_reader_after_noise, testing::Values(1, 3, 8, 64), testing::PrintToStringParamName());

TEST_P(rtu_reader_after_noise, finds_two_requests_in_every_trial)
{
    auto const size   = GetParam();
    auto const seed   = static_cast<unsigned>(2024 + size);
    auto const result = recover(seed, nothing, [size](dice& random) { return random.noise(size); }, nothing);
    std::printf("%u noise bytes, seed %u: both requests found in %u of %u trials; in %u the noise forms a frame\n",
                static_cast<unsigned>(size), seed, result.tried - result.exempt - result.missing, result.tried, result.exempt);
    EXPECT_EQ(result.tried, trials);
    EXPECT_EQ(result.missing, 0U);
    EXPECT_LE(result.exempt, 10U);
}

TEST(rtu_reader, finds_two_requests_after_a_truncated_frame)
{
    auto const result = recover(11, nothing, [](dice& random) {
        auto cut = adu_of(static_cast<int>(random.below(248)), rtu_model::random_pdu(random, request, rtu_model::random_function(random)));
        cut.resize(random.below(cut.size()));
        return cut;
    }, nothing);
    EXPECT_EQ(result.missing, 0U);
    EXPECT_LE(result.exempt, 10U);
}

TEST(rtu_reader, finds_two_requests_after_a_broken_crc)
{
    auto const result = recover(12, nothing, [](dice& random) {
        auto broken = adu_of(static_cast<int>(random.below(248)), rtu_model::random_pdu(random, request, rtu_model::random_function(random)));
        broken[broken.size() - 1 - random.below(2)] ^= static_cast<std::uint8_t>(1 + random.below(255));
        return broken;
    }, nothing);
    EXPECT_EQ(result.missing, 0U);
    EXPECT_LE(result.exempt, 10U);
}

TEST(rtu_reader, finds_two_requests_with_a_stray_zero_between_them)
{
    auto const result = recover(13, nothing, nothing, zero);
    EXPECT_EQ(result.missing, 0U);
    EXPECT_EQ(result.exempt, 0U);
    EXPECT_EQ(recover(14, nothing, zero, zero).missing, 0U);
}

TEST(rtu_reader, finds_two_requests_behind_the_traffic_of_another_server)
{
    auto const traffic = [](dice& random) {
        line heard;
        for (auto left = 1 + random.below(3); left > 0; --left) {
            constexpr std::array functions{1, 3, 4, 6, 16, 23};
            auto const           function = functions[random.below(functions.size())];
            auto const           address  = static_cast<int>(1 + random.below(2));
            for (auto const kind : {request, response}) {
                auto const whole = adu_of(address, rtu_model::random_pdu(random, kind, function));
                heard.insert(heard.end(), whole.begin(), whole.end());
                heard.push_back(silence);
            }
        }
        return heard;
    };
    auto const result = recover(15, traffic, nothing, nothing);
    EXPECT_EQ(result.missing, 0U);
    EXPECT_EQ(result.exempt, 0U);
}

TEST(rtu_reader, finds_two_requests_behind_one_that_nobody_answered)
{
    auto const lost = [](dice& random) {
        auto pdu     = random.noise(5);
        pdu[0]       = random.one_in(2) ? 0x03 : 0x06;
        auto const a = adu_of(static_cast<int>(1 + random.below(2)), pdu);
        return random.one_in(2) ? line_of(a, silence) : line_of(a);
    };
    auto const result = recover(16, lost, nothing, nothing);
    EXPECT_EQ(result.missing, 0U);
    EXPECT_EQ(result.exempt, 0U);
}

TEST(rtu_reader, tells_the_traffic_of_two_servers_apart)
{
    auto const other_asked    = adu_of(99, "03 00 10 00 02"_hex);
    auto const other_answered = adu_of(99, "03 04 11 22 33 44"_hex);
    auto const first          = adu_of(1, "03 00 00 00 02"_hex);
    auto const second         = adu_of(1, "06 00 00 00 02"_hex);
    EXPECT_EQ(read(line_of(other_asked, other_answered, first, other_asked, other_answered, second)),
              (items{frame(request, other_asked), frame(response, other_answered), frame(request, first),
                     frame(request, other_asked), frame(response, other_answered), frame(request, second)}));
}

TEST(rtu_reader, finds_two_requests_after_a_request_that_nobody_answered)
{
    auto const lost   = adu_of(9, "03 00 10 00 02"_hex);
    auto const first  = adu_of(9, "03 00 00 00 02"_hex);
    auto const second = adu_of(9, "06 00 00 00 02"_hex);
    for (auto const& heard : {line_of(lost, silence, first, second, silence), line_of(lost, timeout, first, second),
                              line_of(lost, silence, timeout, first, second), line_of(lost, first, second, silence)}) {
        EXPECT_EQ(read(heard), (items{frame(request, lost), frame(request, first), frame(request, second)}));
    }
}

//=== against the rule, written a second time ===//

using rtu_model::listens_for;

template <typename Reader>
void compare_with_the_rule(Reader const& fresh, rtu_model::rules rules, unsigned seeds, unsigned first_seed)
{
    for (unsigned seed = first_seed; seed < first_seed + seeds; ++seed) {
        dice                                       random{seed};
        auto const                                 heard = rtu_model::random_line(random);
        stream_model::decision<rtu_model::rules>   decide{rules, Reader::max_run};
        auto const                                 expected = decide(heard);
        for (auto const how : {way::in_one_chunk, all_ways[1 + seed % 3]}) {
            auto reader = fresh;
            ASSERT_EQ(read(reader, heard, how, seed), expected)
                << "seed " << seed << ", way " << static_cast<int>(how) << ": " << stream_model::to_text(heard);
            ASSERT_EQ(reader.counters(), stream_model::counters_of<stream_counters>(expected)) << seed;
        }
        ASSERT_EQ(stream_model::bytes_of(expected), stream_model::bytes_of(heard)) << seed;
    }
}

TEST(rtu_reader, decides_as_the_rule_says_on_random_traffic)
{
    compare_with_the_rule(rtu::reader{}, {}, trials / 5, 1);
}

TEST(rtu_reader, decides_as_the_rule_says_with_its_own_address)
{
    compare_with_the_rule(rtu::reader{expecting::either, 1}, {.to = listens_for::either, .own_address = 1}, trials / 10, 10'001);
    compare_with_the_rule(rtu::reader{expecting::response, 2}, {.to = listens_for::responses, .own_address = 2}, trials / 20,
                          20'001);
}

TEST(rtu_reader, decides_as_the_rule_says_when_it_expects_one_direction)
{
    compare_with_the_rule(rtu::reader{expecting::request}, {.to = listens_for::requests}, trials / 20, 30'001);
    compare_with_the_rule(rtu::reader{expecting::response}, {.to = listens_for::responses}, trials / 20, 40'001);
}

template <std::size_t Capacity>
using reader_of = rtu::basic_reader<modbus::public_functions, modbus::crc16::by_default, Capacity>;

TEST(rtu_reader, decides_as_the_rule_says_with_any_capacity)
{
    compare_with_the_rule(reader_of<258>{}, {}, trials / 20, 50'001);
    compare_with_the_rule(reader_of<259>{}, {}, trials / 40, 60'001);
    compare_with_the_rule(reader_of<600>{}, {}, trials / 40, 70'001);
    compare_with_the_rule(reader_of<5000>{}, {}, trials / 40, 80'001);
}

TEST(rtu_reader, decides_as_the_rule_says_on_noise)
{
    for (unsigned seed = 1; seed <= trials / 100; ++seed) {
        dice       random{seed};
        auto const heard = line_of(random.noise(600), seed % 2 == 0 ? silence : timeout, random.noise(400), silence);
        stream_model::decision<rtu_model::rules> decide{{}, rtu::reader::max_run};
        auto const                               expected = decide(heard);
        for (auto const how : all_ways) {
            rtu::reader reader;
            ASSERT_EQ(read(reader, heard, how, seed), expected) << seed;
        }
    }
}

//=== work ===//

struct counting_crc {
    static inline std::size_t checksums = 0;
    static inline std::size_t covered   = 0;

    static std::uint16_t update(std::uint16_t crc, bytes data) noexcept
    {
        ++checksums;
        covered += data.size();
        return modbus::crc16::slices::update(crc, data);
    }
};

TEST(rtu_reader, does_a_bounded_amount_of_work_for_each_byte)
{
    using counting_reader = rtu::basic_reader<modbus::public_functions, counting_crc>;
    constexpr std::size_t size = 4000;
    std::vector<byte_list> streams;
    for (int byte : {0x00, 0x01, 0x03, 0x14, 0x17, 0x18, 0x2B, 0x42, 0x80, 0xAB, 0xF7, 0xFB, 0xFF}) {
        streams.push_back(byte_list(size, static_cast<std::uint8_t>(byte)));
    }
    for (auto const& pattern : {byte_list{0x01, 0x17, 0xFB}, byte_list{0x17, 0xF0, 0xF0}, byte_list{0x03, 0xFB},
                                byte_list{0x10, 0xF7}, byte_list{0x14, 0xFB}, byte_list{0x0F, 0xF7, 0x0F, 0x03, 0xFB}}) {
        byte_list stream;
        for (std::size_t i = 0; i < size; ++i) { stream.push_back(pattern[i % pattern.size()]); }
        streams.push_back(stream);
    }
    dice random{5};
    streams.push_back(random.noise(size));
    auto few = random.noise(size);  // function bytes and long byte counts only
    for (auto& byte : few) { byte = std::array<std::uint8_t, 4>{0x17, 0xF7, 0x03, 0xFB}[byte % 4]; }
    streams.push_back(few);

    double most = 0;
    for (auto const& stream : streams) {
        for (auto const how : all_ways) {
            counting_reader reader;
            counting_crc::checksums = 0;
            counting_crc::covered   = 0;
            auto const said = read(reader, line_of(stream, silence), how);
            EXPECT_EQ(stream_model::bytes_of(said), stream);
            EXPECT_LE(counting_crc::checksums, stream.size() * rtu::framing<>::max_readings);
            EXPECT_LE(counting_crc::covered, stream.size() * rtu::framing<>::max_readings * rtu::max_adu_size);
            most = std::max(most, static_cast<double>(counting_crc::covered) / static_cast<double>(stream.size()));
        }
    }
    std::printf("at most %.0f bytes are covered by checksums for each byte that comes in\n", most);
}

//=== buffers ===//

TEST(rtu_reader, keeps_what_it_gave_until_the_next_call)
{
    rtu::reader reader;
    auto const  answer = adu_of(1, "03 04 00 01 00 02"_hex);
    auto const  raw    = stream_model::bytes_of(line_of(0xFF, read_two, answer));
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

TEST(rtu_reader, takes_no_more_bytes_than_it_has_room_for)
{
    rtu::reader     reader;
    byte_list const many(1000, 0x01);
    auto const      rest = reader.push(many);
    EXPECT_EQ(rest.size(), 1000 - (rtu::max_adu_size + 64));
    EXPECT_EQ(reader.push(rest).size(), rest.size());
    EXPECT_TRUE(reader.prepare().empty());
}

TEST(rtu_reader, takes_no_bytes_while_a_silence_waits)
{
    rtu::reader reader;
    EXPECT_TRUE(reader.push(bytes{read_two}.first(3)).empty());
    reader.silence();
    EXPECT_TRUE(reader.prepare().empty());
    EXPECT_EQ(reader.push(read_two).size(), read_two.size());
    EXPECT_NE(reader.next().dropped(), nullptr);
    EXPECT_FALSE(reader.next());
    EXPECT_TRUE(reader.push(read_two).empty());
    auto const given = reader.next();
    ASSERT_NE(given.frame(), nullptr);
    EXPECT_TRUE(given.frame()->aligned);
}

TEST(rtu_reader, gives_nothing_of_a_silent_line)
{
    rtu::reader reader;
    for (int i = 0; i < 3; ++i) {
        reader.silence();
        EXPECT_FALSE(reader.next());
    }
    EXPECT_EQ(reader.counters(), stream_counters{});
}

//=== other function sets ===//

TEST(rtu_reader, knows_the_lengths_of_its_functions_only)
{
    using two = rtu::basic_reader<modbus::function_set<modbus::read_holding_registers, modbus::write_single_register>>;
    two        reader;
    auto const coils = adu_of(1, "01 00 00 00 08"_hex);
    EXPECT_EQ(read(reader, line_of(read_two, coils)), (items{frame(request, read_two)}));
    EXPECT_EQ(read(reader, line_of(silence)), (items{frame(request, coils)}));
}

//=== in a constant expression ===//

TEST(rtu_reader, works_in_constant_expressions)
{
    VERIFY([] {
        rtu::reader reader;
        auto const  noise = "FF 00"_hex;
        if (not reader.push(noise).empty() or not reader.push(read_two).empty()) { return false; }
        reader.silence();
        auto const run = reader.next();
        if (run.dropped() == nullptr or not same_bytes(run.dropped()->raw, noise)) { return false; }
        auto const found = reader.next();
        return found.frame() != nullptr and same_bytes(found.frame()->raw, read_two) and found.frame()->address() == 1
               and found.frame()->function() == modbus::function_code::read_holding_registers
               and not found.frame()->aligned and not found.frame()->is_exception() and not reader.next()
               and reader.counters() == stream_counters{.frames = 1, .unaligned_frames = 1, .dropped_runs = 1, .dropped_bytes = 2, .bad_checksums = 1};
    }());
    static_assert([] {
        rtu::reader reader{expecting::response};
        for (auto const byte : frame_within_a_frame) {
            auto const room = reader.prepare();
            room[0]         = byte;
            reader.commit(1);
        }
        auto const found = reader.next();
        return found.frame() != nullptr and found.frame()->aligned and found.frame()->pdu().size() == 10;
    }());
}

}  // namespace
