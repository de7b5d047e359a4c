#include "support/bus_monitor.hpp"

#include "support/recorded_line.hpp"

#include <gtest/gtest.h>

#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using support::traffic;
using buffer = std::vector<std::uint8_t>;

buffer const request{0x11, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x76, 0x87};
buffer const reply{0x11, 0x03, 0x06, 0x02, 0x2B, 0x00, 0x00, 0x00, 0x64, 0xC8, 0xBA};
buffer const exception{0x11, 0x83, 0x02, 0xC1, 0x34};
buffer const other_request{0x02, 0x06, 0x23, 0x29, 0x00, 0x0D, 0x92, 0x70};
buffer const broadcast{0x00, 0x06, 0x00, 0x18, 0x00, 0x01, 0xC9, 0xDC};

//=== recorded lines ===//

TEST(recorded_line, has_a_time_or_none)
{
    auto const timed = support::parse_recorded(" 12.345678 01 02 # at noon");
    EXPECT_EQ(timed.time, 12'345'678U);
    EXPECT_EQ(timed.heard.bytes, (buffer{1, 2}));
    EXPECT_EQ(support::parse_recorded("999999999999.999999").time, 999'999'999'999'999'999U);
    EXPECT_EQ(support::parse_recorded("0.000000\t03").heard.bytes, buffer{3});
    EXPECT_EQ(support::parse_recorded("").time, std::nullopt);
    EXPECT_EQ(support::parse_recorded("01 02").time, std::nullopt);
}

TEST(recorded_line, takes_nothing_else_for_a_time)
{
    for (auto const* const line : {"12.34567 01", "12.3456789 01", ".345678 01", "1234567890123.345678 01",
                                   "12.34567A 01", "A2.345678 01", "12,345678 01", "01 12.345678"}) {
        EXPECT_EQ(support::parse_recorded(line).time, std::nullopt) << line;
    }
}

TEST(recorded_line, counts_columns_from_its_begin)
{
    EXPECT_EQ(support::parse_recorded("12.345678 01 z").heard.column, 14U);
    EXPECT_EQ(support::parse_recorded("01 z").heard.column, 4U);
}

//=== text ===//

TEST(bus_view, cuts_at_blanks)
{
    using lines = std::vector<std::string>;
    EXPECT_EQ(support::wrap("", 4), lines{""});
    EXPECT_EQ(support::wrap("abcd", 4), lines{"abcd"});
    EXPECT_EQ(support::wrap("ab cd", 4), (lines{"ab", "cd"}));
    EXPECT_EQ(support::wrap("abcd ef", 4), (lines{"abcd", "ef"}));
    EXPECT_EQ(support::wrap("abcdefghij", 4), (lines{"abcd", "efgh", "ij"}));
    EXPECT_EQ(support::wrap("a    bcd", 4), (lines{"a", "bcd"}));
    EXPECT_EQ(support::wrap("abcd   ", 4), lines{"abcd"});
}

TEST(bus_view, loses_no_character_and_is_never_too_wide)
{
    std::mt19937 random{1};
    for (int trial = 0; trial < 2000; ++trial) {
        std::string text;
        std::string letters;
        for (auto size = random() % 60; size > 0; --size) {
            text += random() % 4 == 0 ? ' ' : static_cast<char>('a' + random() % 26);
        }
        auto const  width = 1 + random() % 20;
        std::string given;
        for (auto const& line : support::wrap(text, width)) {
            EXPECT_LE(line.size(), width);
            given += line;
        }
        std::erase(text, ' ');
        std::erase(given, ' ');
        EXPECT_EQ(given, text);
    }
}

TEST(bus_view, rounds_the_time_of_a_response)
{
    EXPECT_EQ(support::response_text(1), "+0.0 ms");
    EXPECT_EQ(support::response_text(50), "+0.1 ms");
    EXPECT_EQ(support::response_text(12'345), "+12.3 ms");
    EXPECT_EQ(support::response_text(9'999'949), "+9999.9 ms");
    EXPECT_EQ(support::response_text(10'000'000), "+10.0 s");
    EXPECT_EQ(support::response_text(61'260'000), "+61.3 s");
}

TEST(bus_view, writes_times_since_the_begin_or_of_day)
{
    EXPECT_EQ(support::time_text(12'345'678, 99, false), "12.345");
    EXPECT_EQ(support::time_text(0, 12'345'678, true), "12.345");
    EXPECT_EQ(support::time_text(0, 999'999'999'999'999, true), "999999999.999");
    auto const of_day = support::time_text(0, 1'700'000'000'042'000, true);  // in any time zone
    EXPECT_EQ(of_day.size(), 12U);
    EXPECT_EQ(of_day.substr(of_day.size() - 7), ":20.042");
}

//=== times of bytes ===//

TEST(arrival_times, know_when_an_item_began_and_ended)
{
    support::arrival_times times;
    times.add(3, 10);
    times.add(4, 20);
    times.add(1, std::nullopt);
    times.add(1, 40);
    auto const first = times.take(2);
    EXPECT_EQ(first.begin, 10U);
    EXPECT_EQ(first.end, 10U);
    auto const second = times.take(3);
    EXPECT_EQ(second.begin, 10U);
    EXPECT_EQ(second.end, 20U);
    EXPECT_EQ(times.take(0).begin, 20U);
    EXPECT_EQ(times.take(2).end, 20U);
    EXPECT_EQ(times.take(1).begin, std::nullopt);
    EXPECT_EQ(times.take(1).end, 40U);
    EXPECT_EQ(times.take(0).begin, std::nullopt);
}

//=== statistics ===//

TEST(bus_statistics, have_the_least_mean_and_most_time)
{
    support::response_times times;
    EXPECT_TRUE(times.empty());
    for (auto const time : {30U, 10U, 20U}) { times.add(time); }
    support::response_times more;
    more.add(100);
    more.add(times);
    more.add(support::response_times{});
    EXPECT_EQ(more.least(), 10U);
    EXPECT_EQ(more.mean(), 40U);
    EXPECT_EQ(more.most(), 100U);
}

TEST(bus_statistics, give_dropped_bytes_to_whom_they_belong)
{
    support::bus_statistics counted;
    counted.expect(5);
    counted.add({.kind = traffic::dropped, .address = 3, .seems_from = 5, .size = 1}, {});            // 3 was asked
    counted.add({.kind = traffic::dropped, .seems_from = 5, .is_bad_check = true, .size = 10}, {});   // 5 is known
    counted.add({.kind = traffic::dropped, .seems_from = 6, .is_bad_check = true, .size = 100}, {});  // 6 is not
    counted.add({.kind = traffic::dropped, .size = 1000}, {});
    EXPECT_EQ(counted.rows().at(3).dropped_bytes, 1U);
    EXPECT_EQ(counted.rows().at(5).dropped_bytes, 10U);
    EXPECT_EQ(counted.rows().at(5).bad_checks, 1U);
    EXPECT_FALSE(counted.rows().contains(6));
    EXPECT_EQ(counted.line().dropped_bytes, 1100U);
    EXPECT_EQ(counted.total().dropped_bytes, 1111U);
    EXPECT_EQ(counted.total().bad_checks, 2U);
}

//=== all of it ===//

class BusMonitor : public testing::Test {
protected:
    void hear(buffer const& bytes, std::optional<support::timestamp> now = {})
    {
        monitor_.hear(bytes, now);
        monitor_.hear_nothing(now);
    }

    [[nodiscard]] support::bus_counters const& row(std::uint8_t address) const
    {
        return monitor_.statistics().rows().at(address);
    }

    support::bus_monitor_options chosen_;
    std::ostringstream           out_;
    support::bus_monitor         monitor_{chosen_, out_};
};

TEST_F(BusMonitor, pairs_requests_with_replies_and_refusals)
{
    hear(request, 1'000'000);
    hear(reply, 1'010'000);
    hear(request, 1'100'000);
    hear(exception, 1'130'000);
    EXPECT_EQ(row(0x11).requests, 2U);
    EXPECT_EQ(row(0x11).replies, 1U);
    EXPECT_EQ(row(0x11).refusals, 1U);
    EXPECT_EQ(row(0x11).silences, 0U);
    EXPECT_EQ(row(0x11).times.least(), 10'000U);
    EXPECT_EQ(row(0x11).times.mean(), 20'000U);
    EXPECT_EQ(row(0x11).times.most(), 30'000U);
    EXPECT_TRUE(monitor_.is_healthy());
}

TEST_F(BusMonitor, a_reply_to_somebody_else_is_none)
{
    hear(other_request, 1);
    hear(reply, 2);
    EXPECT_EQ(row(2).silences, 1U);
    EXPECT_EQ(row(0x11).replies, 1U);
    EXPECT_TRUE(monitor_.statistics().total().times.empty());
    EXPECT_NE(out_.str().find("no request heard"), std::string::npos);
    EXPECT_FALSE(monitor_.is_healthy());
}

TEST_F(BusMonitor, a_second_reply_answers_nothing)
{
    hear(request, 1);
    hear(reply, 2);
    hear(reply, 3);
    EXPECT_EQ(row(0x11).replies, 2U);
    EXPECT_EQ(row(0x11).times.most(), 1U);
    EXPECT_NE(out_.str().find("no request heard"), std::string::npos);
}

TEST_F(BusMonitor, a_broadcast_is_not_answered)
{
    hear(broadcast);
    EXPECT_FALSE(monitor_.is_waiting_for_response());
    hear(request);
    monitor_.end(true);
    EXPECT_EQ(row(0).requests, 1U);
    EXPECT_EQ(row(0).silences, 0U);
    EXPECT_EQ(row(0x11).silences, 1U);
}

TEST_F(BusMonitor, who_stops_listening_does_not_know_whether_a_reply_came)
{
    hear(request);
    monitor_.end(false);
    EXPECT_EQ(row(0x11).silences, 0U);
}

TEST_F(BusMonitor, gives_up_a_request_after_its_time)
{
    hear(request, 1'000'000);
    monitor_.hear_nothing(2'000'000);
    EXPECT_EQ(row(0x11).silences, 0U);
    monitor_.hear_nothing(2'000'001);
    EXPECT_EQ(row(0x11).silences, 1U);
    monitor_.hear_nothing(9'000'000);
    EXPECT_EQ(row(0x11).silences, 1U);
}

TEST_F(BusMonitor, bytes_that_were_read_at_once_have_no_response_time)
{
    auto both = request;
    both.insert(both.end(), reply.begin(), reply.end());
    hear(both, 1);
    EXPECT_EQ(row(0x11).replies, 1U);
    EXPECT_TRUE(row(0x11).times.empty());
}

TEST_F(BusMonitor, times_that_run_backwards_do_no_harm)
{
    hear(request, 5'000'000);
    hear(reply, 4'000'000);
    EXPECT_EQ(row(0x11).replies, 1U);
    EXPECT_TRUE(row(0x11).times.empty());
}

TEST_F(BusMonitor, measures_from_the_last_byte_of_the_request_to_the_first_of_the_reply)
{
    for (std::size_t i = 0; i < request.size(); ++i) {
        monitor_.hear(drivecodec::bytes{request}.subspan(i, 1), 100 + i);
    }
    for (std::size_t i = 0; i < reply.size(); ++i) { monitor_.hear(drivecodec::bytes{reply}.subspan(i, 1), 200 + i); }
    EXPECT_EQ(row(0x11).times.least(), 200U - 107U);
}

TEST(bus_drives, say_which_drive_is_where)
{
    support::bus_drives drives;
    drives.add("5=smd");
    drives.add("0x11=xd1000:fan 2");
    EXPECT_EQ(drives.name_of(5), "smd");
    EXPECT_EQ(drives.name_of(17), "fan 2");
    EXPECT_EQ(drives.name_of(6), "");
    EXPECT_EQ(drives.longest_name(), 5U);
    for (auto const* const word : {"", "5", "5=", "=smd", "248=smd", "0=smd", "5=smd2", "x=smd"}) {
        EXPECT_THROW(drives.add(word), support::usage_error) << word;
    }
}

}  // namespace
