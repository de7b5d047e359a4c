#include <drivecodec/core/error.hpp>

#include "support/verify.hpp"

#include <type_traits>

namespace {

using drivecodec::errc;
using drivecodec::error;

TEST(error, is_nothing_unless_told)
{
    VERIFY(error{}.ok());
    VERIFY(error{} == error{errc::none, 0});
    VERIFY(static_cast<int>(errc::none) == 0);
}

TEST(error, says_what_and_where)
{
    VERIFY(not error{errc::bad_value, 3}.ok());
    VERIFY(error{errc::bad_value, 3}.code() == errc::bad_value);
    VERIFY(error{errc::bad_value, 3}.offset() == 3);
    VERIFY(error{errc::bad_value, 3} != error{errc::bad_value, 4});
    VERIFY(error{errc::bad_value, 3} != error{errc::bad_length, 3});
}

TEST(error, moves_with_the_bytes_around_it)
{
    VERIFY(error{errc::bad_value, 3}.moved_by(1) == error{errc::bad_value, 4});
    VERIFY(error{errc::truncated, 5}.moved_by(1).moved_by(2) == error{errc::truncated, 8});
    VERIFY(error{errc::bad_value, 3}.moved_by(0) == error{errc::bad_value, 3});
}

TEST(error, that_is_none_stays_none_when_moved)
{
    VERIFY(error{}.moved_by(7) == error{});
}

TEST(error, holds_every_code)
{
    for (unsigned value = 0; value <= static_cast<unsigned>(errc::unreachable); ++value) {
        auto const code = static_cast<errc>(value);
        ASSERT_EQ(error(code, 0xFFFF).code(), code);
        ASSERT_EQ(error(code, 0xFFFF).offset(), 0xFFFF);
    }
}

TEST(error, fits_in_a_register)
{
    VERIFY(sizeof(error) == 4);
    VERIFY(std::is_trivially_copyable_v<error>);
}

}  // namespace
