#include <drivecodec/core/deframer.hpp>

#include "support/hex.hpp"
#include "support/stream_model.hpp"
#include "support/verify.hpp"

namespace {

using drivecodec::bytes;
using drivecodec::deframer;
using drivecodec::errc;
using drivecodec::message_length;
using drivecodec::stream_counters;
using stream_model::all_ways;
using stream_model::byte_list;
using stream_model::dropped;
using stream_model::frame;
using stream_model::item;
using stream_model::line;
using stream_model::line_of;
using stream_model::silence;
using stream_model::way;
using items = std::vector<item>;

/// A protocol small enough that all its streams can be tried. A frame has two to four bytes and is intact if their sum
/// is a multiple of four; its first byte tells how the two readings find its length. A frame 1 turns their order around.
struct small_framing {
    struct frame {
        bytes    raw;
        unsigned reading;
        bool     aligned;
    };

    static constexpr unsigned    max_readings   = 2;
    static constexpr std::size_t min_frame_size = 2;
    static constexpr std::size_t max_frame_size = 4;

    bool turned = false;

    [[nodiscard]] constexpr message_length length(bytes front, unsigned reading) const noexcept
    {
        auto const is_first = (reading == 0) != turned;
        switch (front[0]) {
        case 1: return message_length::exactly(is_first ? 3 : 2);
        case 2:
            if (not is_first) { return message_length::at_least(5); }
            return front.size() < 2 ? message_length::at_least(2) : message_length::exactly(std::size_t{front[1]} + 2);
        case 3:
            if (is_first) { return message_length::until_silence(); }
            return front.size() < 3 ? message_length::at_least(3) : message_length::exactly(front[2]);
        default: return message_length::impossible();
        }
    }

    [[nodiscard]] static constexpr bool is_intact(bytes whole) noexcept
    {
        unsigned sum = 0;
        for (auto const byte : whole) { sum += byte; }
        return sum % 4 == 0;
    }

    [[nodiscard]] constexpr frame accept(bytes raw, unsigned reading, bool aligned) noexcept
    {
        if (raw.front() == 1) { turned = not turned; }
        return {raw, reading, aligned};
    }
};
static_assert(drivecodec::framing<small_framing>);

/// The same as the rule has it.
struct small_rules {
    using reading = stream_model::reading;
    using what    = reading::what;

    static constexpr std::size_t min_size = 2;
    static constexpr std::size_t max_size = 4;

    bool turned = false;

    [[nodiscard]] std::array<reading, 2> readings(bytes front) const
    {
        std::array<reading, 2> made{{{0, what::impossible}, {1, what::impossible}}};
        auto&                  first  = made[turned ? 1 : 0];
        auto&                  second = made[turned ? 0 : 1];
        if (front[0] == 1) {
            first.says  = second.says = what::has_size;
            first.size  = 3;
            second.size = 2;
        } else if (front[0] == 2) {
            first.says  = front.size() < 2 ? what::needs_more : what::has_size;
            first.size  = front.size() < 2 ? 2 : std::size_t{front[1]} + 2;
            second.says = what::needs_more;
            second.size = 5;
        } else if (front[0] == 3) {
            first.says  = what::until_silence;
            second.says = front.size() < 3 ? what::needs_more : what::has_size;
            second.size = front.size() < 3 ? 3 : front[2];
        }
        return made;
    }

    [[nodiscard]] static bool is_intact(bytes whole) { return small_framing::is_intact(whole); }
    void                      took(int, bytes whole) { turned = (whole[0] == 1) != turned; }
    void                      timed_out() {}
};

/// The same, but shorter frames than the longest are none.
struct long_framing : small_framing {
    static constexpr std::size_t min_frame_size = 4;
};
struct long_rules : small_rules {
    static constexpr std::size_t min_size = 4;
};

constexpr auto kind_of = [](small_framing::frame const& f) { return static_cast<int>(f.reading); };

template <std::size_t Capacity, typename Framing = small_framing, typename Rules = small_rules>
void compare_with_the_rule(line const& heard, way how, unsigned seed = 1)
{
    using reader_type = deframer<Framing, Capacity>;
    stream_model::decision<Rules> decide{{}, reader_type::max_run};
    auto const                    expected = decide(heard);
    reader_type                   reader;
    ASSERT_EQ(stream_model::read(reader, heard, how, kind_of, seed), expected) << stream_model::to_text(heard);
    ASSERT_EQ(reader.counters(), stream_model::counters_of<stream_counters>(expected)) << stream_model::to_text(heard);
    if (not heard.empty() and heard.back() == silence) {
        ASSERT_EQ(stream_model::bytes_of(expected), stream_model::bytes_of(heard)) << stream_model::to_text(heard);
    }
}

TEST(deframer, decides_every_short_stream_as_the_rule_says)
{
    constexpr std::size_t longest = 6;
    line                  heard;
    for (std::size_t size = 0; size <= longest; ++size) {
        heard.assign(size, silence);
        for (bool more = true; more;) {
            ASSERT_NO_FATAL_FAILURE((compare_with_the_rule<6>(heard, way::byte_by_byte)));
            ASSERT_NO_FATAL_FAILURE((compare_with_the_rule<16>(heard, way::in_one_chunk)));
            ASSERT_NO_FATAL_FAILURE((compare_with_the_rule<6, long_framing, long_rules>(heard, way::byte_by_byte)));
            more = false;
            for (auto& what : heard) {  // the next one: silence, 0, 1, 2, 3 count like digits
                if (what < 3) {
                    ++what;
                    more = true;
                    break;
                }
                what = silence;
            }
        }
    }
}

TEST(deframer, decides_long_streams_as_the_rule_says)
{
    std::mt19937 random{7};
    for (unsigned seed = 1; seed <= 1500; ++seed) {
        line heard;
        for (auto left = 10 + random() % 60; left > 0; --left) {
            auto const number = static_cast<int>(random() % 60);
            heard.push_back(number < 3 ? silence : number % 4);
        }
        heard.push_back(silence);
        auto const how = all_ways[seed % all_ways.size()];
        ASSERT_NO_FATAL_FAILURE((compare_with_the_rule<6>(heard, how, seed)));
        ASSERT_NO_FATAL_FAILURE((compare_with_the_rule<7>(heard, how, seed)));
        ASSERT_NO_FATAL_FAILURE((compare_with_the_rule<64>(heard, how, seed)));
    }
}

//=== one rule at a time ===//

items read(line const& heard)
{
    deframer<small_framing, 32> reader;
    return stream_model::read(reader, heard, way::in_one_chunk, kind_of);
}

TEST(deframer, waits_for_the_reading_that_comes_first)
{
    EXPECT_EQ(read({1, 3}), items{});                                                            // 1 3 is intact
    EXPECT_EQ(read({1, 3, silence}), (items{frame(1, line{1, 3})}));                             // and nothing follows
    EXPECT_EQ(read({1, 3, 0}), (items{frame(0, line{1, 3, 0})}));                                // the first is right
    EXPECT_EQ(read({1, 3, 1, silence}), (items{frame(1, line{1, 3}), dropped(errc::truncated, line{1})}));  // it is wrong
}

TEST(deframer, knows_what_is_impossible_at_once)
{
    EXPECT_EQ(read({0, 1, 3, 0}), (items{dropped(errc::bad_length, line{0}), frame(0, line{1, 3, 0}, false)}));
    // Five bytes are too many for either reading of 02 03.
    EXPECT_EQ(read({2, 3, 1, 1, 3, 0}),
              (items{dropped(errc::bad_length, line{2, 3, 1}), frame(0, line{1, 3, 0}, false)}));
}

TEST(deframer, does_not_wait_for_what_is_too_short_to_be_a_frame)
{
    deframer<long_framing, 32> reader;
    EXPECT_EQ(stream_model::read(reader, {2, 1, 2, 2, 0, 0}, way::in_one_chunk, kind_of),
              (items{dropped(errc::bad_length, line{2, 1}), frame(0, line{2, 2, 0, 0}, false)}));
    EXPECT_EQ(stream_model::read(reader, {2, 1, silence}, way::in_one_chunk, kind_of),
              (items{dropped(errc::bad_length, line{2, 1})}));
}

TEST(deframer, ends_a_frame_at_a_silence_only_if_it_is_aligned)
{
    EXPECT_EQ(read({3, 1, silence}), (items{frame(0, line{3, 1})}));
    EXPECT_EQ(read({0, 3, 1, silence}), (items{dropped(errc::bad_length, line{0, 3, 1})}));
    EXPECT_EQ(read({1, 3, 0, 3, 1, silence}), (items{frame(0, line{1, 3, 0}), frame(1, line{3, 1})}));
}

TEST(deframer, says_whether_a_frame_is_aligned)
{
    line const found{2, 2, 0, 0};
    EXPECT_EQ(read(line_of(found)), (items{frame(0, found)}));
    EXPECT_EQ(read(line_of(found, found)), (items{frame(0, found), frame(0, found)}));
    EXPECT_EQ(read(line_of(0, found, found)),
              (items{dropped(errc::bad_length, line{0}), frame(0, found, false), frame(0, found)}));
    EXPECT_EQ(read(line_of(0, silence, found)), (items{dropped(errc::bad_length, line{0}), frame(0, found)}));
}

TEST(deframer, cuts_long_runs_alike_however_the_bytes_come)
{
    using reader_type = deframer<small_framing, 10>;
    static_assert(reader_type::max_run == 5);
    for (auto const how : all_ways) {
        reader_type reader;
        EXPECT_EQ(stream_model::read(reader, line(12, 0), how, kind_of),
                  (items{dropped(errc::bad_length, line(5, 0)), dropped(errc::bad_length, line(5, 0))}));
        EXPECT_EQ(stream_model::read(reader, line{0, 0, 1, 3, 0}, how, kind_of),
                  (items{dropped(errc::bad_length, line(4, 0)), frame(0, line{1, 3, 0}, false)}));
    }
}

TEST(deframer, says_of_a_run_what_was_wrong_with_its_first_byte)
{
    EXPECT_EQ(read({1, 1, 1, 0, silence}), (items{dropped(errc::bad_checksum, line{1, 1, 1, 0})}));
    EXPECT_EQ(read({2, 2, silence}), (items{dropped(errc::truncated, line{2, 2})}));
    EXPECT_EQ(read({0, 1, 1, 1, silence}), (items{dropped(errc::bad_length, line{0, 1, 1, 1})}));
}

//=== bytes in ===//

TEST(deframer, gives_room_until_it_is_full)
{
    deframer<small_framing, 6> reader;
    EXPECT_EQ(reader.prepare().size(), 6U);
    EXPECT_EQ(reader.push("02 02"_hex).size(), 0U);
    EXPECT_EQ(reader.prepare().size(), 4U);
    reader.commit(0);
    EXPECT_EQ(reader.prepare().size(), 4U);
    auto const five = "00 00 01 03 00"_hex;
    auto const rest = reader.push(five);
    EXPECT_EQ(rest.size(), 1U);
    EXPECT_EQ(rest.data(), five.data() + 4);
    EXPECT_TRUE(reader.prepare().empty());
    EXPECT_NE(reader.next().frame(), nullptr);
    EXPECT_FALSE(reader.next());
    EXPECT_EQ(reader.push(rest).size(), 0U);
    EXPECT_NE(reader.next().frame(), nullptr);
    EXPECT_EQ(reader.prepare().size(), 6U);
}

TEST(deframer, begins_as_after_a_silence)
{
    deframer<small_framing> reader{small_framing{.turned = true}};
    EXPECT_TRUE(reader.push("01 03 00"_hex).empty());
    auto const given = reader.next();
    ASSERT_NE(given.frame(), nullptr);
    EXPECT_TRUE(given.frame()->aligned);
    EXPECT_EQ(given.frame()->reading, 0U);
    EXPECT_EQ(given.frame()->raw.size(), 2U);
    EXPECT_FALSE(reader.scheme().turned);
}

TEST(deframer, ignores_silences_while_nothing_waits)
{
    deframer<small_framing> reader;
    reader.silence();
    reader.silence();
    EXPECT_FALSE(reader.next());
    EXPECT_FALSE(reader.prepare().empty());
}

TEST(deframer, judges_waiting_bytes_anew_when_asked_to)
{
    deframer<small_framing> reader;
    EXPECT_TRUE(reader.push("01 03"_hex).empty());
    EXPECT_FALSE(reader.next());
    reader.scheme().turned = true;
    reader.reconsider();
    auto const given = reader.next();
    ASSERT_NE(given.frame(), nullptr);
    EXPECT_EQ(given.frame()->raw.size(), 2U);
}

TEST(deframer, works_in_constant_expressions)
{
    VERIFY([] {
        deframer<small_framing, 6> reader;
        constexpr auto             stream = "01 03 00 00 02 02 00 00 00"_hex;
        for (bytes rest = stream; not rest.empty();) {
            rest = reader.push(rest);
            while (reader.next()) {}
        }
        return reader.counters()
               == stream_counters{.frames = 2, .unaligned_frames = 1, .dropped_runs = 2, .dropped_bytes = 2};
    }());
}

TEST(deframer, is_as_large_as_its_buffer_and_a_few_bytes)
{
    static_assert(sizeof(deframer<small_framing, 256>) <= 256 + 48);
}

}  // namespace
