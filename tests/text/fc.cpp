#include <drivecodec/text/fc.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec;

constexpr bool reads(auto const& thing, std::string_view expected)
{
    std::array<char, 100> room{};
    return describe(thing, room) == expected;
}

TEST(text_fc, has_a_word_for_everything)
{
    VERIFY(to_string(errc::bad_checksum) == "bad_checksum");
    VERIFY(to_string(fc::ak_command::read_value) == "read_value");
    VERIFY(explain(fc::parameter_error::not_an_array) == "the parameter is no array, but an element was asked for");
    VERIFY(reads(fc::address::short_format(22), "slave 22"));
    VERIFY(reads(fc::reference::from_raw(0x2000), "50.00 %"));
    VERIFY(reads(fc::process_command{fc::data_not_valid}, "PCD 0000 0000"));
}

}  // namespace
