#include <drivecodec/core/message_length.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::message_length;

TEST(message_length, is_one_of_four)
{
    constexpr auto kinds = [](message_length length) {
        return (length.is_exact() ? 1 : 0) + (length.is_open() ? 2 : 0) + (length.is_until_silence() ? 4 : 0)
               + (length.is_impossible() ? 8 : 0);
    };
    VERIFY(kinds(message_length::exactly(8)) == 1);
    VERIFY(kinds(message_length::at_least(8)) == 2);
    VERIFY(kinds(message_length::until_silence()) == 4);
    VERIFY(kinds(message_length::impossible()) == 8);
}

TEST(message_length, says_how_many)
{
    VERIFY(message_length::exactly(8).size() == 8);
    VERIFY(message_length::at_least(256).size() == 256);
}

TEST(message_length, grows_by_what_is_around)
{
    VERIFY(message_length::exactly(5).plus(3) == message_length::exactly(8));
    VERIFY(message_length::at_least(5).plus(3) == message_length::at_least(8));
    VERIFY(message_length::until_silence().plus(3) == message_length::until_silence());
    VERIFY(message_length::impossible().plus(3) == message_length::impossible());
}

TEST(message_length, compares_kind_and_size)
{
    VERIFY(message_length::exactly(5) != message_length::exactly(6));
    VERIFY(message_length::exactly(5) != message_length::at_least(5));
    VERIFY(message_length::until_silence() != message_length::impossible());
}

// A count that doubles must not wrap around to a short message.
TEST(message_length, that_no_message_has_stays_longer_than_every_message)
{
    VERIFY(message_length::exactly(0xFFFF).size() == 0xFFFF);
    VERIFY(message_length::exactly(0x1'0000).size() == 0xFFFF);
    VERIFY(message_length::exactly(7 + 2 * 0xFFFF).size() == 0xFFFF);
    VERIFY(message_length::at_least(0x1'0001).size() == 0xFFFF);
    VERIFY(message_length::exactly(0xFFFF).plus(3).size() == 0xFFFF);
}

}  // namespace
