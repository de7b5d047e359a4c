#include <drivecodec/core/be16.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <array>
#include <random>
#include <vector>

namespace {

using namespace drivecodec;

constexpr std::size_t max_words  = 130;
constexpr std::size_t alignments = 8;

TEST(be16, loads_constants)
{
    constexpr auto loaded = [] {
        std::array<std::uint16_t, 3> words{};
        load_be16("02 2B 00 00 80 64"_hex, words);
        return words;
    };
    VERIFY(loaded() == std::array<std::uint16_t, 3>{0x022B, 0x0000, 0x8064});
}

TEST(be16, stores_constants)
{
    constexpr auto stored = [] {
        std::array<std::uint8_t, 6> wire{};
        store_be16(std::array<std::uint16_t, 3>{0x022B, 0x0000, 0x8064}, wire);
        return wire;
    };
    VERIFY(stored() == "02 2B 00 00 80 64"_hex);
}

TEST(be16, of_nothing_is_nothing)
{
    load_be16({}, {});
    store_be16({}, {});
}

// The blocks that a vectorising compiler makes have edges: every number of words, at every alignment.
TEST(be16, loads_every_number_of_words_at_every_alignment)
{
    std::mt19937              random{1};
    std::vector<std::uint8_t> wire(2 * max_words + alignments);
    for (auto& byte : wire) { byte = static_cast<std::uint8_t>(random()); }

    for (std::size_t alignment = 0; alignment < alignments; ++alignment) {
        for (std::size_t count = 0; count <= max_words; ++count) {
            std::vector<std::uint16_t> words(count + 1, 0xBEEF);
            load_be16(bytes{wire}.subspan(alignment, 2 * count), std::span{words}.first(count));
            for (std::size_t i = 0; i < count; ++i) {
                auto const high = wire[alignment + 2 * i];
                auto const low  = wire[alignment + 2 * i + 1];
                ASSERT_EQ(words[i], high * 256 + low) << i << " of " << count << " at " << alignment;
            }
            ASSERT_EQ(words[count], 0xBEEF) << count << " at " << alignment;
        }
    }
}

TEST(be16, stores_every_number_of_words_at_every_alignment)
{
    std::mt19937               random{2};
    std::vector<std::uint16_t> words(max_words);
    for (auto& word : words) { word = static_cast<std::uint16_t>(random()); }

    for (std::size_t alignment = 0; alignment < alignments; ++alignment) {
        for (std::size_t count = 0; count <= max_words; ++count) {
            std::vector<std::uint8_t> wire(alignment + 2 * count + 1, 0xEE);
            store_be16(std::span{words}.first(count), mutable_bytes{wire}.subspan(alignment, 2 * count));
            for (std::size_t i = 0; i < count; ++i) {
                ASSERT_EQ(wire[alignment + 2 * i], words[i] / 256) << i << " of " << count << " at " << alignment;
                ASSERT_EQ(wire[alignment + 2 * i + 1], words[i] % 256) << i << " of " << count << " at " << alignment;
            }
            ASSERT_EQ(wire.back(), 0xEE) << count << " at " << alignment;
            for (std::size_t i = 0; i < alignment; ++i) { ASSERT_EQ(wire[i], 0xEE) << count << " at " << alignment; }
        }
    }
}

}  // namespace
