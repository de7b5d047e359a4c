// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace drivecodec {

namespace compile_error {
template <int Bits>
void pattern_must_be_made_of_0_1_x_and_have_exactly_this_many_bits();  // not constexpr: its name is the error text
}  // namespace compile_error

/// A word of which some bits do not matter, written as the standards write it: `"x01x 0001"`, most significant bit
/// first, blanks ignored.
template <std::unsigned_integral Raw>
struct basic_pattern {
    static constexpr int bits = 8 * sizeof(Raw);

    Raw mask{};
    Raw value{};

    template <std::size_t N>
    consteval basic_pattern(char const (&text)[N])
    {
        int seen = 0;
        for (auto const c : text) {
            if (c == ' ' or c == '\0') { continue; }
            if (c != '0' and c != '1' and c != 'x') { refuse(); }
            ++seen;
            mask  = static_cast<Raw>((mask << 1) | (c != 'x' ? 1 : 0));
            value = static_cast<Raw>((value << 1) | (c == '1' ? 1 : 0));
        }
        if (seen != bits) { refuse(); }
    }

    [[nodiscard]] constexpr bool matches(Raw word) const noexcept { return (word & mask) == value; }

    /// Is there a word that both match?
    [[nodiscard]] friend constexpr bool overlap(basic_pattern a, basic_pattern b) noexcept
    {
        return ((a.value ^ b.value) & a.mask & b.mask) == 0;
    }

private:
    static consteval void refuse()
    {
        compile_error::pattern_must_be_made_of_0_1_x_and_have_exactly_this_many_bits<bits>();
    }
};

using pattern   = basic_pattern<std::uint16_t>;
using pattern_8 = basic_pattern<std::uint8_t>;

}  // namespace drivecodec
