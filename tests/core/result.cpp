#include <drivecodec/core/result.hpp>

#include "support/verify.hpp"

#include <cstdint>

namespace {

using drivecodec::errc;
using drivecodec::error;
using drivecodec::result;

struct point {
    int x;
    int y;

    friend constexpr bool operator==(point, point) = default;
};

struct incomparable {
    int x;
};

enum class refusal : std::uint8_t { no = 1, never = 2 };

constexpr error too_short{errc::truncated, 4};

TEST(result, holds_a_value)
{
    constexpr result<int> seven = 7;
    VERIFY(seven.has_value());
    VERIFY(static_cast<bool>(seven));
    VERIFY(*seven == 7);
    VERIFY(result<point>{{1, 2}}->y == 2);
}

TEST(result, holds_an_error)
{
    constexpr result<int> failed = too_short;
    VERIFY(not failed.has_value());
    VERIFY(not static_cast<bool>(failed));
    VERIFY(failed.error() == too_short);
}

TEST(result, takes_a_fallback)
{
    VERIFY(result<int>{7}.value_or(8) == 7);
    VERIFY(result<int>{too_short}.value_or(8) == 8);
}

TEST(result, compares_values_and_errors)
{
    VERIFY(result<int>{7} == result<int>{7});
    VERIFY(result<int>{7} != result<int>{8});
    VERIFY(result<int>{7} != result<int>{too_short});
    VERIFY(result<int>{too_short} == result<int>{too_short});
    VERIFY(result<int>{too_short} != result<int>{error{errc::truncated, 5}});
    VERIFY(result<point>{{1, 2}} == result<point>{{1, 2}});
}

TEST(result, of_what_cannot_be_compared_cannot_be_compared)
{
    VERIFY(not std::equality_comparable<result<incomparable>>);
    VERIFY(std::equality_comparable<result<point>>);
}

TEST(result, takes_another_kind_of_error)
{
    constexpr result<int, refusal> refused = refusal::never;
    VERIFY(not refused);
    VERIFY(refused.error() == refusal::never);
    VERIFY(refused != result<int, refusal>{refusal::no});
    VERIFY(std::is_same_v<decltype(refused)::error_type, refusal>);
    VERIFY(std::is_same_v<decltype(refused)::value_type, int>);
}

TEST(result, is_as_plain_as_what_it_holds)
{
    VERIFY(std::is_trivially_copyable_v<result<int>>);
    VERIFY(std::is_trivially_copyable_v<result<point, refusal>>);
    VERIFY(std::is_trivially_destructible_v<result<point>>);
    VERIFY(not std::is_default_constructible_v<result<int>>);
}

TEST(result, does_not_turn_into_a_number)
{
    VERIFY(not std::is_convertible_v<result<int>, bool>);
    VERIFY(not std::is_convertible_v<result<int>, int>);
}

}  // namespace
