#include <drivecodec/core/stream_item.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

namespace {

using drivecodec::dropped_bytes;
using drivecodec::errc;
using drivecodec::stream_counters;

struct whole {
    int number;
};
using item = drivecodec::stream_item<whole>;

constexpr auto three = "01 02 03"_hex;

TEST(stream_item, holds_nothing_at_first)
{
    VERIFY(not item{});
    VERIFY(item{}.frame() == nullptr);
    VERIFY(item{}.dropped() == nullptr);
}

TEST(stream_item, holds_a_frame)
{
    static constexpr item given{whole{7}};
    VERIFY(static_cast<bool>(given));
    VERIFY(given.frame()->number == 7);
    VERIFY(given.dropped() == nullptr);
}

TEST(stream_item, holds_dropped_bytes)
{
    static constexpr item given{dropped_bytes{.raw = three, .reason = errc::bad_checksum}};
    VERIFY(static_cast<bool>(given));
    VERIFY(given.frame() == nullptr);
    VERIFY(given.dropped()->raw.data() == three.data());
    VERIFY(given.dropped()->raw.size() == 3);
    VERIFY(given.dropped()->reason == errc::bad_checksum);
}

TEST(stream_item, is_copied_like_its_bytes)
{
    static_assert(std::is_trivially_copyable_v<item>);
    item given{whole{7}};
    given = item{dropped_bytes{.raw = three, .reason = errc::truncated}};
    EXPECT_EQ(given.frame(), nullptr);
    given = item{whole{8}};
    ASSERT_NE(given.frame(), nullptr);
    EXPECT_EQ(given.frame()->number, 8);
}

constexpr stream_counters counted(auto count)
{
    stream_counters counters;
    count(counters);
    return counters;
}

TEST(stream_counters, count_frames)
{
    VERIFY(counted([](auto& c) { c.count_frame(true); }) == stream_counters{.frames = 1});
    VERIFY(counted([](auto& c) { c.count_frame(false); }) == stream_counters{.frames = 1, .unaligned_frames = 1});
}

TEST(stream_counters, count_dropped_bytes_and_why)
{
    VERIFY(counted([](auto& c) { c.count_dropped(5, errc::bad_length); })
           == stream_counters{.dropped_runs = 1, .dropped_bytes = 5});
    VERIFY(counted([](auto& c) { c.count_dropped(5, errc::bad_checksum); })
           == stream_counters{.dropped_runs = 1, .dropped_bytes = 5, .bad_checksums = 1});
    VERIFY(counted([](auto& c) {
               c.count_dropped(5, errc::truncated);
               c.count_dropped(2, errc::truncated);
           })
           == stream_counters{.dropped_runs = 2, .dropped_bytes = 7, .truncated = 2});
}

TEST(stream_counters, wrap_around)
{
    VERIFY(counted([](auto& c) {
               c.frames        = 0xFFFF'FFFF;
               c.dropped_bytes = 0xFFFF'FFFE;
               c.count_frame(true);
               c.count_dropped(3, errc::bad_length);
           })
           == stream_counters{.frames = 0, .dropped_runs = 1, .dropped_bytes = 1});
}

}  // namespace
