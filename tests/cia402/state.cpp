#include <drivecodec/cia402/state.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::cia402;
using drivecodec::errc;

/// The state by the masks that the standard prints beside its patterns, or -1: 4Fh where the quick stop bit does not
/// matter, 6Fh where it does.
constexpr int state_by_masks(unsigned word)
{
    switch (word & 0x4FU) {
    case 0x00: return static_cast<int>(state::not_ready_to_switch_on);
    case 0x40: return static_cast<int>(state::switch_on_disabled);
    case 0x0F: return static_cast<int>(state::fault_reaction_active);
    case 0x08: return static_cast<int>(state::fault);
    default: break;
    }
    switch (word & 0x6FU) {
    case 0x21: return static_cast<int>(state::ready_to_switch_on);
    case 0x23: return static_cast<int>(state::switched_on);
    case 0x27: return static_cast<int>(state::operation_enabled);
    case 0x07: return static_cast<int>(state::quick_stop_active);
    default: return -1;
    }
}

constexpr int decoded(unsigned word)
{
    auto const found = decode_state(status_word::from_raw(static_cast<std::uint16_t>(word)));
    return found ? static_cast<int>(*found) : -1;
}

TEST(state, is_what_the_standard_s_masks_say_for_all_65536_words)
{
    for (unsigned word = 0; word <= 0xFFFF; ++word) { ASSERT_EQ(decoded(word), state_by_masks(word)) << word; }
}

/// A host decodes by the one, firmware by the other; here both are run.
TEST(state, is_the_same_whether_it_is_decoded_fast_or_small)
{
    for (unsigned word = 0; word <= 0xFFFF; ++word) {
        auto const wanted = state_by_masks(word) < 0 ? state_count : static_cast<unsigned>(state_by_masks(word));
        ASSERT_EQ(detail::find_state_fast(word), wanted) << word;
        ASSERT_EQ(detail::find_state_small(word), wanted) << word;
    }
}

TEST(state, of_104_of_128_words_is_an_error)
{
    constexpr auto none = [] {
        int count = 0;
        for (unsigned word = 0; word < 128; ++word) { count += decoded(word) < 0 ? 1 : 0; }
        return count;
    }();
    VERIFY(none == 104);
    VERIFY(decode_state(status_word::from_raw(0x0002)).error() == drivecodec::error{errc::bad_value, 0});
}

TEST(state, does_not_depend_on_voltage_warning_remote_or_any_higher_bit)
{
    constexpr unsigned other_bits = 0xFF90;
    for (unsigned word = 0; word < 128; ++word) {
        for (unsigned bit = 0; bit < 16; ++bit) {
            auto const others = other_bits & (1U << bit);
            ASSERT_EQ(decoded(word | others), decoded(word & ~others)) << word << ' ' << bit;
        }
    }
}

TEST(state, matches_at_most_one_pattern)
{
    for (unsigned byte = 0; byte <= 0xFF; ++byte) {
        int matches = 0;
        for (auto const& row : state_codings) {
            matches += row.low_byte.matches(static_cast<std::uint8_t>(byte)) ? 1 : 0;
        }
        ASSERT_EQ(matches, decoded(byte) < 0 ? 0 : 1) << byte;
    }
}

TEST(state, has_its_row_at_its_place)
{
    for (std::size_t i = 0; i < state_count; ++i) { EXPECT_EQ(static_cast<std::size_t>(state_codings[i].state), i); }
}

}  // namespace
