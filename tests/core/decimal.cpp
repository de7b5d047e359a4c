#include <drivecodec/core/decimal.hpp>

#include "support/verify.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace {

using namespace drivecodec;

constexpr auto least = std::numeric_limits<std::int32_t>::min();
constexpr auto most  = std::numeric_limits<std::int32_t>::max();

//=== the oracle: numbers as people write them ===//

struct written {
    bool        negative;
    std::string digits;  // without leading zeros: 0 has none
};

[[nodiscard]] written written_down(std::int64_t number)
{
    if (number == 0) { return {false, ""}; }
    return {number < 0, std::to_string(number < 0 ? -number : number)};
}

/// With `count` zeros more. None make a 0 longer.
[[nodiscard]] written with_zeros(written of, int count)
{
    if (not of.digits.empty()) { of.digits.append(static_cast<std::size_t>(count), '0'); }
    return of;
}

[[nodiscard]] std::weak_ordering order_of_magnitudes(std::string const& a, std::string const& b)
{
    if (a.size() != b.size()) { return a.size() <=> b.size(); }
    return a.compare(b) <=> 0;
}

[[nodiscard]] std::weak_ordering expected_order(decimal a, decimal b)
{
    auto const finest = std::min(a.exponent, b.exponent);
    auto const left   = with_zeros(written_down(a.number), a.exponent - finest);
    auto const right  = with_zeros(written_down(b.number), b.exponent - finest);
    if (left.negative != right.negative) {
        return left.negative ? std::weak_ordering::less : std::weak_ordering::greater;
    }
    return left.negative ? order_of_magnitudes(right.digits, left.digits)
                         : order_of_magnitudes(left.digits, right.digits);
}

[[nodiscard]] result<std::int32_t> expected_scale(decimal of, int to)
{
    auto scaled = written_down(of.number);
    if (scaled.digits.empty()) { return 0; }
    if (of.exponent >= to) {
        scaled = with_zeros(scaled, of.exponent - to);
    } else {
        auto const lost = static_cast<std::size_t>(to - of.exponent);
        auto const last = scaled.digits.find_last_not_of('0');
        if (scaled.digits.size() - last - 1 < lost) { return error{errc::inexact, 0}; }
        scaled.digits.resize(scaled.digits.size() - lost);
    }
    if (order_of_magnitudes(scaled.digits, scaled.negative ? "2147483648" : "2147483647") > 0) {
        return error{errc::out_of_range, 0};
    }
    auto const magnitude = std::stoll(scaled.digits);
    return static_cast<std::int32_t>(scaled.negative ? -magnitude : magnitude);
}

/// Numbers of every length, often with zeros at the end, often at a limit; exponents near each other and far apart.
class numbers {
public:
    [[nodiscard]] decimal next() { return {number(), exponent()}; }

    [[nodiscard]] std::int8_t exponent()
    {
        return static_cast<std::int8_t>(below(4) == 0 ? below(256) - 128 : below(25) - 12);
    }

private:
    [[nodiscard]] int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }

    [[nodiscard]] std::int32_t number()
    {
        constexpr std::array limits{least, least + 1, least / 10 - 1, least / 10,    -1,
                                    0,     1,         most / 10,      most / 10 + 1, most};
        if (below(8) == 0) { return limits[static_cast<std::size_t>(below(limits.size()))]; }
        std::int64_t drawn = static_cast<std::int32_t>(random_()) >> below(32);
        for (auto zeros = below(10); zeros > 0 and drawn * 10 <= most and drawn * 10 >= least; --zeros) { drawn *= 10; }
        return static_cast<std::int32_t>(drawn);
    }

    std::mt19937 random_{1};
};

constexpr int draws = 100'000;

template <decimal Value>
struct of_value {};

TEST(decimal, is_two_members_and_nothing_else)
{
    VERIFY(std::is_aggregate_v<decimal> and std::is_trivially_copyable_v<decimal> and sizeof(decimal) == 8);
    VERIFY(decimal{}.number == 0 and decimal{}.exponent == 0);
    VERIFY(std::is_same_v<of_value<decimal{5, -1}>, of_value<decimal{5, -1}>>);
    VERIFY(not std::is_same_v<of_value<decimal{5, 0}>, of_value<decimal{50, -1}>>);
}

//=== scaled_to ===//

TEST(decimal, is_scaled_exactly_or_not_at_all)
{
    VERIFY(*decimal{500, -1}.scaled_to(-1) == 500);
    VERIFY(*decimal{500, -1}.scaled_to(-2) == 5000);
    VERIFY(*decimal{500, -1}.scaled_to(0) == 50);
    VERIFY(*decimal{500, -1}.scaled_to(1) == 5);
    VERIFY(decimal{500, -1}.scaled_to(2).error() == error{errc::inexact, 0});
    VERIFY(decimal{412, -1}.scaled_to(0).error() == error{errc::inexact, 0});
    VERIFY(*decimal{-412, -1}.scaled_to(-3) == -41'200);
    VERIFY(*decimal{4, 3}.scaled_to(0) == 4000);
}

TEST(decimal, is_scaled_up_to_the_limits_of_32_bits)
{
    VERIFY(*decimal{most, 0}.scaled_to(0) == most);
    VERIFY(*decimal{least, 0}.scaled_to(0) == least);
    VERIFY(decimal{most, 0}.scaled_to(-1).error() == error{errc::out_of_range, 0});
    VERIFY(decimal{least, 0}.scaled_to(-1).error() == error{errc::out_of_range, 0});
    VERIFY(decimal{most, 0}.scaled_to(1).error() == error{errc::inexact, 0});
    VERIFY(decimal{least, 0}.scaled_to(1).error() == error{errc::inexact, 0});
    VERIFY(*decimal{214'748'364, 0}.scaled_to(-1) == 2'147'483'640);
    VERIFY(*decimal{-214'748'364, 0}.scaled_to(-1) == -2'147'483'640);
    VERIFY(decimal{214'748'365, 0}.scaled_to(-1).error() == error{errc::out_of_range, 0});
    VERIFY(decimal{-214'748'365, 0}.scaled_to(-1).error() == error{errc::out_of_range, 0});
    VERIFY(*decimal{1, 9}.scaled_to(0) == 1'000'000'000);
    VERIFY(decimal{1, 10}.scaled_to(0).error() == error{errc::out_of_range, 0});
    VERIFY(*decimal{1'000'000'000, 0}.scaled_to(9) == 1);
    VERIFY(decimal{1'000'000'000, 0}.scaled_to(10).error() == error{errc::inexact, 0});
}

TEST(decimal, of_0_has_every_scale)
{
    for (int exponent = -128; exponent <= 127; ++exponent) {
        for (int to = -300; to <= 300; ++to) {
            auto const scaled = decimal{0, static_cast<std::int8_t>(exponent)}.scaled_to(to);
            ASSERT_TRUE(scaled and *scaled == 0) << exponent << " to " << to;
        }
    }
}

TEST(decimal, is_scaled_to_whatever_an_int_is)
{
    constexpr auto lowest  = std::numeric_limits<int>::min();
    constexpr auto highest = std::numeric_limits<int>::max();
    VERIFY(*decimal{0, 127}.scaled_to(lowest) == 0 and *decimal{0, -128}.scaled_to(highest) == 0);
    VERIFY(decimal{1, 127}.scaled_to(lowest).error() == error{errc::out_of_range, 0});
    VERIFY(decimal{1, -128}.scaled_to(highest).error() == error{errc::inexact, 0});
}

TEST(decimal, is_scaled_as_its_digits_are_moved_on_paper)
{
    numbers random;
    for (int i = 0; i < draws; ++i) {
        auto const value    = random.next();
        auto const to       = int{random.exponent()};
        auto const scaled   = value.scaled_to(to);
        auto const expected = expected_scale(value, to);
        ASSERT_EQ(scaled.has_value(), expected.has_value()) << value.number << "e" << +value.exponent << " to " << to;
        if (expected) {
            ASSERT_EQ(*scaled, *expected) << value.number << "e" << +value.exponent << " to " << to;
        } else {
            ASSERT_EQ(scaled.error(), expected.error()) << value.number << "e" << +value.exponent << " to " << to;
        }
    }
}

//=== order and sign ===//

TEST(decimal, is_equal_however_it_is_written)
{
    VERIFY(decimal{500, -1} == decimal{50, 0});
    VERIFY(decimal{5, 1} == decimal{50, 0});
    VERIFY(decimal{0, 127} == decimal{0, -128});
    VERIFY(decimal{} == decimal{0, 5});
    VERIFY(decimal{501, -1} != decimal{50, 0});
    VERIFY(decimal{-50, 0} != decimal{50, 0});
}

// Equal values may have other digits, so one cannot stand for the other.
TEST(decimal, is_ordered_weakly)
{
    VERIFY(std::is_same_v<decltype(decimal{} <=> decimal{}), std::weak_ordering>);
    VERIFY((decimal{50, 0} <=> decimal{500, -1}) == std::weak_ordering::equivalent);
}

TEST(decimal, is_ordered_by_value)
{
    VERIFY(decimal{412, -1} < decimal{42, 0});
    VERIFY(decimal{-412, -1} > decimal{-42, 0});
    VERIFY(decimal{most, -128} < decimal{1, 127});
    VERIFY(decimal{least, -128} > decimal{-1, 127});
    VERIFY(decimal{most, 127} > decimal{least, 127});
    VERIFY(decimal{1, -128} > decimal{0, 127});
    VERIFY(decimal{-1, -128} < decimal{0, 127});
    VERIFY(decimal{214'748'365, 1} > decimal{most, 0});
    VERIFY(decimal{-214'748'365, 1} < decimal{least, 0});
    VERIFY(decimal{214'748'364, 1} < decimal{most, 0});
    VERIFY(decimal{-214'748'364, 1} > decimal{least, 0});
}

TEST(decimal, is_ordered_as_digits_under_each_other_are)
{
    numbers random;
    for (int i = 0; i < draws; ++i) {
        auto const a        = random.next();
        auto const b        = random.next();
        auto const expected = expected_order(a, b);
        ASSERT_TRUE((a <=> b) == expected) << a.number << "e" << +a.exponent << ", " << b.number << "e" << +b.exponent;
        ASSERT_EQ(a == b, expected == 0) << a.number << "e" << +a.exponent << ", " << b.number << "e" << +b.exponent;
    }
}

// Random pairs are seldom equal or neighbours.
TEST(decimal, is_ordered_against_its_neighbours_of_every_scale)
{
    numbers random;
    for (int i = 0; i < draws / 10; ++i) {
        auto const value = random.next();
        for (int exponent = -128; exponent <= 127; ++exponent) {
            auto const scaled = value.scaled_to(exponent);
            if (not scaled) { continue; }
            auto const same = decimal{*scaled, static_cast<std::int8_t>(exponent)};
            ASSERT_TRUE(same == value) << value.number << "e" << +value.exponent << " at " << exponent;
            if (*scaled < most) {
                ASSERT_TRUE(value < (decimal{*scaled + 1, same.exponent})) << value.number << "e" << +value.exponent;
            }
            if (*scaled > least) {
                ASSERT_TRUE(value > (decimal{*scaled - 1, same.exponent})) << value.number << "e" << +value.exponent;
            }
        }
    }
}

TEST(decimal, has_an_opposite_with_the_same_digits)
{
    VERIFY((-decimal{500, -1}).number == -500);
    VERIFY((-decimal{500, -1}).exponent == -1);
    VERIFY(-decimal{most, 0} == decimal{least + 1, 0});
    VERIFY(-decimal{} == decimal{});
}

//=== parse_decimal ===//

[[nodiscard]] constexpr bool reads(std::string_view text, std::int32_t number, int exponent) noexcept
{
    auto const read = parse_decimal(text);
    return read and read->number == number and read->exponent == exponent;
}

[[nodiscard]] constexpr bool refuses(std::string_view text, errc why, std::size_t where) noexcept
{
    auto const read = parse_decimal(text);
    return not read and read.error() == error{why, where};
}

TEST(parse_decimal, keeps_every_digit)
{
    VERIFY(reads("50", 50, 0));
    VERIFY(reads("50.0", 500, -1));
    VERIFY(reads("50.00", 5000, -2));
    VERIFY(reads("0.001", 1, -3));
    VERIFY(reads("0", 0, 0));
    VERIFY(reads("0.0", 0, -1));
    VERIFY(reads("010", 10, 0));
}

TEST(parse_decimal, takes_a_sign)
{
    VERIFY(reads("-41.2", -412, -1));
    VERIFY(reads("+41.2", 412, -1));
    VERIFY(reads("-0", 0, 0));
}

TEST(parse_decimal, takes_a_point_anywhere)
{
    VERIFY(reads(".5", 5, -1));
    VERIFY(reads("-.5", -5, -1));
    VERIFY(reads("5.", 5, 0));
}

TEST(parse_decimal, takes_groups_of_digits)
{
    VERIFY(reads("1'000", 1000, 0));
    VERIFY(reads("2'147'483'647", most, 0));
    VERIFY(reads("0.000'1", 1, -4));
}

TEST(parse_decimal, refuses_what_cannot_be_there)
{
    VERIFY(refuses(" 1", errc::bad_value, 0));
    VERIFY(refuses("1 ", errc::bad_value, 1));
    VERIFY(refuses("--1", errc::bad_value, 1));
    VERIFY(refuses("1-", errc::bad_value, 1));
    VERIFY(refuses("'1", errc::bad_value, 0));
    VERIFY(refuses("1''0", errc::bad_value, 2));
    VERIFY(refuses("1'.5", errc::bad_value, 2));
    VERIFY(refuses("1.'5", errc::bad_value, 2));
    VERIFY(refuses("1'", errc::truncated, 3));
    VERIFY(refuses("1.2.3", errc::bad_value, 3));
    VERIFY(refuses("1e3", errc::bad_value, 1));
    VERIFY(refuses("0x10", errc::bad_value, 1));
    VERIFY(refuses("0b1", errc::bad_value, 1));
    VERIFY(refuses("1,5", errc::bad_value, 1));
    VERIFY(refuses(std::string_view{"1\0", 2}, errc::bad_value, 1));
    VERIFY(parse_decimal("50").error() == error{errc::bad_value, 2});  // an array of characters: with the zero
}

TEST(parse_decimal, takes_no_other_character_for_a_digit)
{
    for (int code = 0; code <= 255; ++code) {
        std::string const text{'1', static_cast<char>(code), '2'};
        auto const        may_stand = text[1] == '.' or text[1] == '\'' or (code >= '0' and code <= '9');
        if (may_stand) {
            ASSERT_TRUE(parse_decimal(text)) << code;
        } else {
            ASSERT_TRUE(refuses(text, errc::bad_value, 1)) << code;
        }
    }
}

TEST(parse_decimal, needs_a_digit)
{
    VERIFY(refuses("", errc::truncated, 1));
    VERIFY(refuses("-", errc::truncated, 2));
    VERIFY(refuses("+", errc::truncated, 2));
    VERIFY(refuses(".", errc::truncated, 2));
    VERIFY(refuses("-.", errc::truncated, 3));
}

TEST(parse_decimal, refuses_the_first_digit_that_does_not_fit)
{
    VERIFY(reads("2147483647", most, 0));
    VERIFY(reads("-2147483647", -most, 0));
    VERIFY(reads("-2147483648", least, 0));
    VERIFY(refuses("2147483648", errc::out_of_range, 9));
    VERIFY(refuses("21474836470", errc::out_of_range, 10));
    VERIFY(refuses("-2147483649", errc::out_of_range, 10));
    VERIFY(refuses("2.147483648", errc::out_of_range, 10));
    VERIFY(refuses("9999999999", errc::out_of_range, 9));
}

TEST(parse_decimal, takes_128_digits_after_the_point)
{
    auto const zeros = std::string(127, '0');
    EXPECT_TRUE(reads("." + zeros + "1", 1, -128));
    EXPECT_TRUE(refuses("." + zeros + "10", errc::out_of_range, 129));
    EXPECT_TRUE(refuses("0." + zeros + "00", errc::out_of_range, 130));
}

TEST(parse_decimal, reads_what_printing_writes)
{
    numbers random;
    for (int i = 0; i < draws; ++i) {
        auto const number = random.next().number;
        auto       text   = written_down(number).digits;
        if (text.empty()) { text = "0"; }
        for (std::size_t point = 0; point <= text.size(); ++point) {
            auto with_point = text;
            with_point.insert(point, ".");
            if (number < 0) { with_point.insert(0, "-"); }
            ASSERT_TRUE(reads(with_point, number, static_cast<int>(point) - static_cast<int>(text.size())))
                << with_point;
        }
    }
}

/// The grammar, rule by rule, on strings: sign? digits? ("." digits?)?, with a digit, and ' between digits.
std::optional<std::pair<std::int64_t, int>> by_the_grammar(std::string_view text)
{
    auto const is_digit = [](char c) { return c >= '0' and c <= '9'; };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\'') { continue; }
        if (i == 0 or i + 1 == text.size() or not is_digit(text[i - 1]) or not is_digit(text[i + 1])) { return {}; }
    }
    std::string rest;
    for (auto const c : text) {
        if (c != '\'') { rest += c; }
    }
    bool const negative = rest.starts_with('-');
    if (negative or rest.starts_with('+')) { rest.erase(0, 1); }
    auto const point  = rest.find('.');
    auto const behind = point == std::string::npos ? 0 : rest.size() - point - 1;
    if (point != std::string::npos) { rest.erase(point, 1); }
    if (rest.empty() or rest.find_first_not_of("0123456789") != std::string::npos) { return {}; }
    return std::pair{std::stoll(rest) * (negative ? -1 : 1), -static_cast<int>(behind)};
}

TEST(parse_decimal, accepts_the_grammar_and_nothing_else)
{
    constexpr std::string_view alphabet = "09.'-+e";
    for (std::size_t length = 0; length <= 6; ++length) {
        std::string text(length, alphabet[0]);
        for (bool more = true; more;) {
            auto const expected = by_the_grammar(text);
            auto const read     = parse_decimal(text);
            ASSERT_EQ(read.has_value(), expected.has_value()) << text;
            if (read) {
                ASSERT_EQ(read->number, expected->first) << text;
                ASSERT_EQ(read->exponent, expected->second) << text;
            } else if (read.error().code() == errc::truncated) {
                ASSERT_EQ(read.error().offset(), text.size() + 1) << text;
                ASSERT_TRUE(by_the_grammar(text + '0')) << text;  // a digit is all it lacks
            } else {
                // What stands before could still have become a number.
                ASSERT_EQ(read.error().code(), errc::bad_value) << text;
                auto const before = text.substr(0, read.error().offset());
                ASSERT_TRUE(by_the_grammar(before) or by_the_grammar(before + '0')) << text;
                ASSERT_FALSE(by_the_grammar(before + text[before.size()] + '0')) << text;
            }
            more = false;
            for (auto& c : text) {
                auto const at = alphabet.find(c) + 1;
                if (at < alphabet.size()) {
                    c    = alphabet[at];
                    more = true;
                    break;
                }
                c = alphabet[0];
            }
        }
    }
}

}  // namespace
