#include <drivecodec/text/fc/main_value.hpp>

#include "support/verify.hpp"

#include <array>
#include <set>
#include <string>

namespace {

using drivecodec::describe;
using drivecodec::fc::output_frequency;
using drivecodec::fc::reference;

template <typename Value>
constexpr bool reads(std::uint16_t raw, std::string_view expected)
{
    std::array<char, 40> room{};
    return describe(Value::from_raw(raw), room) == expected;
}

TEST(text_main_value, is_a_percentage_to_the_nearest_hundredth)
{
    VERIFY(reads<reference>(0x0000, "0.00 %"));
    VERIFY(reads<reference>(0x2000, "50.00 %"));
    VERIFY(reads<reference>(0x4000, "100.00 %"));
    VERIFY(reads<output_frequency>(0xC000, "-100.00 %"));
    VERIFY(reads<output_frequency>(0xE000, "-50.00 %"));
    VERIFY(reads<reference>(0x0001, "0.01 %"));  // 0.0061 %
    VERIFY(reads<reference>(0xFFFF, "-0.01 %"));
    VERIFY(reads<reference>(0x1000, "25.00 %"));
}

TEST(text_main_value, ends_at_199_99_percent)
{
    VERIFY(reads<reference>(0x7FFF, "199.99 %"));
    VERIFY(reads<reference>(0x8001, "-199.99 %"));
    VERIFY(reads<reference>(0x8000, "8000"));
}

}  // namespace
