#pragma once

#include <drivecodec/core/word.hpp>

/// A word of bits and an enumeration of no drive, as the types of a register.
struct lamps : drivecodec::word<lamps, std::uint16_t> {
    static constexpr drivecodec::flag<lamps> red{0};
};
enum class colour : std::uint16_t { red = 1, green = 2, last = 0xFFFF };
