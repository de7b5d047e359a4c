#include <drivecodec/text/core.hpp>

#include "support/enum_names.hpp"
#include "support/hex.hpp"
#include "support/verify.hpp"

#include <array>

namespace {

using drivecodec::describe;
using drivecodec::dropped_bytes;
using drivecodec::errc;
using drivecodec::error;
using drivecodec::explain;
using drivecodec::stream_counters;

constexpr bool reads(auto const& thing, std::string_view expected)
{
    std::array<char, 200> buffer{};
    return describe(thing, buffer) == expected;
}

TEST(text_errc, has_a_name_for_every_error)
{
    EXPECT_EQ(names_of_all_values<errc>().size(), static_cast<std::size_t>(errc::unreachable) + 1);
    VERIFY(to_string(errc::none) == "none");
    VERIFY(to_string(errc::bad_quantity) == "bad_quantity");
    VERIFY(to_string(errc::no_space) == "no_space");
    VERIFY(to_string(errc::read_only) == "read_only");
    VERIFY(to_string(errc::inexact) == "inexact");
    VERIFY(to_string(errc::out_of_range) == "out_of_range");
    VERIFY(to_string(errc::unreachable) == "unreachable");
}

TEST(text_errc, explains_what_has_a_name)
{
    std::set<std::string_view> sentences;
    for (unsigned value = 0; value <= 0xFF; ++value) {
        auto const code = static_cast<errc>(value);
        EXPECT_EQ(explain(code).empty(), to_string(code).empty()) << value;
        if (not explain(code).empty()) { EXPECT_TRUE(sentences.insert(explain(code)).second) << explain(code); }
    }
    VERIFY(explain(errc::bad_quantity) == "a quantity is outside the limits of its function");
}

TEST(text_error, says_what_and_where)
{
    VERIFY(reads(error{}, "none"));
    VERIFY(reads(error{errc::bad_quantity, 4}, "bad_quantity at byte 4"));
    VERIFY(reads(error{errc::bad_checksum, 0}, "bad_checksum at byte 0"));
    VERIFY(reads(error{errc::truncated, 8}, "truncated, 8 bytes needed"));
    VERIFY(reads(error{errc::no_space, 256}, "no_space, 256 bytes needed"));
    VERIFY(reads(error{errc::exception_reply, 2}, "exception_reply 2"));
    VERIFY(reads(error{errc::read_only, 0}, "read_only"));
    VERIFY(reads(error{errc::inexact, 0}, "inexact"));
    VERIFY(reads(error{errc::out_of_range, 0}, "out_of_range"));
    VERIFY(reads(error{errc::unreachable, 0}, "unreachable"));
    VERIFY(reads(error{errc::out_of_range, 9}, "out_of_range at byte 9"));
    VERIFY(reads(error{static_cast<errc>(31), 7}, "error 31 at byte 7"));
}

TEST(text_dropped_bytes, shows_them)
{
    constexpr auto raw = "01 02 FF"_hex;
    VERIFY(reads(dropped_bytes{raw, errc::bad_checksum}, "dropped 3 bytes  bad_checksum: 01 02 FF"));
    VERIFY(reads(dropped_bytes{drivecodec::bytes{raw}.first(1), errc::truncated}, "dropped 1 byte  truncated: 01"));
}

TEST(text_stream_counters, are_all_shown)
{
    VERIFY(reads(stream_counters{1, 2, 3, 4, 5, 6}, "frames=1 unaligned_frames=2 dropped_runs=3 dropped_bytes=4 "
                                                    "bad_checksums=5 truncated=6"));
}

TEST(text_describe, ends_with_dots_where_it_does_not_fit)
{
    std::array<char, 12> buffer{};
    EXPECT_EQ(describe(error{errc::bad_quantity, 4}, buffer), "bad_quant...");
}

}  // namespace
