#pragma once

// What every description in a room of characters keeps to.

#include "fuzz_common.hpp"

#include <string_view>

using characters = exact_array<char>;

/// `describe(room)` in plenty of room, of `most` characters, and in `room`: the whole text or its beginning, printable,
/// never a character outside.
template <typename Describe>
void check_description(std::size_t most, std::size_t room, Describe describe)
{
    characters const       plenty{most};
    std::string_view const whole = describe(plenty.get());
    FUZZ_ASSERT(not whole.empty() and whole.size() < most and whole.data() == plenty.get().data());
    for (auto const character : whole) { FUZZ_ASSERT(character >= ' ' and character <= '~'); }
    FUZZ_ASSERT(whole.back() != ' ');

    characters const       narrow{room % (whole.size() + 2)};
    std::string_view const part = describe(narrow.get());
    auto const             size = narrow.get().size();
    if (size >= whole.size()) {
        FUZZ_ASSERT(part == whole);
        return;
    }
    auto const dots = size < 3 ? size : 3;
    FUZZ_ASSERT(part.size() == size);
    FUZZ_ASSERT(part.substr(0, size - dots) == whole.substr(0, size - dots));
    FUZZ_ASSERT(part.substr(size - dots) == std::string_view{"..."}.substr(0, dots));
}
