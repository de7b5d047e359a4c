#include <drivecodec/text/writer.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

namespace {

using drivecodec::bytes;
using drivecodec::text_writer;

/// Does what `write` writes equal `expected`?
constexpr bool writes(std::string_view expected, auto write)
{
    std::array<char, 100> buffer{};
    text_writer           out{buffer};
    write(out);
    return out.view() == expected and out.needed() == expected.size() and out.is_complete();
}

TEST(text_writer, writes_text)
{
    VERIFY(writes("", [](auto&) {}));
    VERIFY(writes("a", [](auto& out) { out.put('a'); }));
    VERIFY(writes("one two", [](auto& out) { out.put("one").put(' ').put("two"); }));
}

TEST(text_writer, writes_decimal_numbers)
{
    VERIFY(writes("0", [](auto& out) { out.decimal(0U); }));
    VERIFY(writes("255", [](auto& out) { out.decimal(std::uint8_t{255}); }));
    VERIFY(writes("65535", [](auto& out) { out.decimal(std::uint16_t{65535}); }));
    VERIFY(writes("18446744073709551615", [](auto& out) { out.decimal(std::numeric_limits<std::uint64_t>::max()); }));
    VERIFY(writes("9223372036854775807", [](auto& out) { out.decimal(std::numeric_limits<std::int64_t>::max()); }));
}

TEST(text_writer, writes_negative_numbers)
{
    VERIFY(writes("-1", [](auto& out) { out.decimal(-1); }));
    VERIFY(writes("-128", [](auto& out) { out.decimal(std::int8_t{-128}); }));
    VERIFY(writes("-9223372036854775808", [](auto& out) { out.decimal(std::numeric_limits<std::int64_t>::min()); }));
}

TEST(text_writer, writes_all_hexadecimal_digits_of_the_type)
{
    VERIFY(writes("0A", [](auto& out) { out.hex(std::uint8_t{0x0A}); }));
    VERIFY(writes("00BC", [](auto& out) { out.hex(std::uint16_t{0xBC}); }));
    VERIFY(writes("DEADBEEF", [](auto& out) { out.hex(std::uint32_t{0xDEADBEEF}); }));
    VERIFY(writes("0123456789ABCDEF", [](auto& out) { out.hex(std::uint64_t{0x0123'4567'89AB'CDEF}); }));
}

// Not in the lambdas: Clang 14 would call the literal at run time.
constexpr auto one         = "2A"_hex;
constexpr auto three       = "2A 00 FF"_hex;
constexpr auto ascii       = "56 32 2E 31 31"_hex;
constexpr auto unprintable = "00 1F 20 7E 7F 80 FF"_hex;
constexpr auto special     = "22 5C"_hex;

TEST(text_writer, writes_bytes)
{
    VERIFY(writes("", [](auto& out) { out.hex(bytes{}); }));
    VERIFY(writes("2A", [](auto& out) { out.hex(one); }));
    VERIFY(writes("2A 00 FF", [](auto& out) { out.hex(three); }));
    VERIFY(writes("2A00FF", [](auto& out) { out.hex(three, ""); }));
    VERIFY(writes("2A, 00, FF", [](auto& out) { out.hex(three, ", "); }));
}

TEST(text_writer, escapes_what_is_not_printable)
{
    VERIFY(writes(R"("")", [](auto& out) { out.quoted(bytes{}); }));
    VERIFY(writes(R"("V2.11")", [](auto& out) { out.quoted(ascii); }));
    VERIFY(writes(R"("\x00\x1F ~\x7F\x80\xFF")", [](auto& out) { out.quoted(unprintable); }));
    VERIFY(writes(R"("\"\\")", [](auto& out) { out.quoted(special); }));
}

TEST(text_writer, only_measures_without_a_buffer)
{
    constexpr auto needed = [] {
        text_writer out;
        out.put("twelve ").decimal(12).put(' ').hex(std::uint8_t{12});
        return out.view().empty() and not out.is_complete() ? out.needed() : 0;
    }();
    VERIFY(needed == 12);
}

TEST(text_writer, never_writes_outside)
{
    std::string const whole = "dropped 65535 AB \"\\x01\"";
    for (std::size_t size = 0; size <= whole.size() + 1; ++size) {
        auto const  buffer = std::make_unique<char[]>(size);  // a sanitizer sees the first byte outside
        text_writer out{{buffer.get(), size}};
        out.put("dropped ").decimal(65535).put(' ').hex(std::uint8_t{0xAB}).put(' ').quoted("01"_hex);
        EXPECT_EQ(out.view(), whole.substr(0, size));
        EXPECT_EQ(out.needed(), whole.size());
        EXPECT_EQ(out.is_complete(), size >= whole.size());
    }
}

TEST(text_writer, shows_where_it_left_out)
{
    auto const cut_to = [](std::size_t size) {
        std::array<char, 20> buffer{};
        text_writer          out{std::span{buffer}.first(size)};
        out.put("abcdef");
        return std::string{out.view_with_ellipsis()};
    };
    EXPECT_EQ(cut_to(6), "abcdef");
    EXPECT_EQ(cut_to(7), "abcdef");
    EXPECT_EQ(cut_to(5), "ab...");
    EXPECT_EQ(cut_to(4), "a...");
    EXPECT_EQ(cut_to(3), "...");
    EXPECT_EQ(cut_to(2), "..");
    EXPECT_EQ(cut_to(1), ".");
    EXPECT_EQ(cut_to(0), "");
}

}  // namespace
