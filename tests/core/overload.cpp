#include <drivecodec/core/overload.hpp>

#include "support/verify.hpp"

#include <type_traits>

namespace {

using drivecodec::overload;

TEST(overload, calls_the_one_that_fits)
{
    constexpr overload which{[](int) { return 1; }, [](char const*) { return 2; }};
    VERIFY(which(7) == 1);
    VERIFY(which("seven") == 2);
}

TEST(overload, takes_a_catch_all_last)
{
    constexpr overload which{[](int) { return 1; }, [](auto const&) { return 3; }};
    VERIFY(which(7) == 1);
    VERIFY(which(7.0) == 3);
}

TEST(overload, is_not_callable_with_what_it_lacks)
{
    constexpr overload which{[](int*) { return 1; }};
    VERIFY(std::is_invocable_v<decltype(which), int*>);
    VERIFY(not std::is_invocable_v<decltype(which), double>);
}

TEST(overload, keeps_the_state_of_its_parts)
{
    int      calls = 0;
    overload count{[&calls](int by) { calls += by; }, [&calls](char const*) { calls = 0; }};
    count(2);
    count(3);
    EXPECT_EQ(calls, 5);
    count("reset");
    EXPECT_EQ(calls, 0);
}

}  // namespace
