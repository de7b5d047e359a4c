// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/word.hpp>
#include <drivecodec/text/writer.hpp>

#include <array>

namespace drivecodec {

/// What a 1 of a word's bit means.
template <typename Word>
struct flag_name {
    flag<Word>       bit;
    std::string_view name;
};

/// The names of the bits that are 1, each after a blank, in the order of `names`; what is left of the word comes last, in
/// hexadecimal: ` fault_reset halt +0010`.
template <typename Word, std::size_t N>
constexpr void write_flags(text_writer& out, Word word, std::array<flag_name<Word>, N> const& names) noexcept
{
    for (auto const& each : names) {
        if (word.test(each.bit)) { out.put(' ').put(each.name); }
        word = word.without(each.bit);
    }
    if (word.raw != 0) { out.put(" +").hex(word.raw); }
}

}  // namespace drivecodec
