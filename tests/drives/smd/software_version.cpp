#include <drivecodec/drives/smd/software_version.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using smd::software_version;

// "SMD 1.51" in ASCII, two characters a register.
constexpr std::array<std::uint16_t, 4> words{0x534D, 0x4420, 0x312E, 0x3531};

TEST(smd_software_version, is_a_text_of_four_words)
{
    VERIFY(software_version::make(words)->view() == "SMD 1.51");
    VERIFY(software_version::make(words)->words().words == words);
    for (std::size_t count = 0; count < 4; ++count) {
        EXPECT_EQ(software_version::make(std::span{words}.first(count)).error(), (error{errc::bad_quantity, 0}));
    }
    VERIFY(software_version::make(std::array<std::uint16_t, 5>{}).error() == error{errc::bad_quantity, 0});
}

TEST(smd_software_version, keeps_all_bits)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const                         word = static_cast<std::uint16_t>(raw);
        std::array<std::uint16_t, 4> const given{word, 0, 0xFFFF, word};
        ASSERT_EQ(software_version::make(given)->words().words, given);
    }
}

TEST(smd_software_version, is_read_where_each_version_has_it)
{
    constexpr smd::software_version_parameter<smd::pv400> pv400;
    constexpr smd::software_version_parameter<smd::pv507> pv507;
    VERIFY(pv400.read().range.first() == 89 and pv400.read().range.count() == 4);
    VERIFY(pv507.read().range.first() == 95 and pv507.read().range.count() == 4);
    VERIFY(pv507.value(words)->view() == "SMD 1.51" and pv507.address() == 95 and pv507.row.code == "C99");
}

}  // namespace
