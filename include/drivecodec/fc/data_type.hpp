// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::fc {

/// The type of a parameter's value, by the number that Danfoss gives it. VLT 6000 manual, "Data types supported by the
/// VLT frequency converter"; the last four are of newer FC guides. Any other number may come.
enum class data_type : std::uint8_t {
    integer_16      = 3,
    integer_32      = 4,
    unsigned_8      = 5,
    unsigned_16     = 6,
    unsigned_32     = 7,
    text_string     = 9,
    byte_string     = 10,
    time_difference = 13,
    reserved        = 33,
    bit_sequence    = 35,
};

/// How many words of the parameter value (PWE) a type takes; commands and replies say it too.
enum class width : std::uint8_t { word, double_word };

[[nodiscard]] constexpr bool is_signed(data_type type) noexcept
{
    return type == data_type::integer_16 or type == data_type::integer_32;
}

/// Is it one of the five types of numbers, of which width and sign are known?
[[nodiscard]] constexpr bool is_number(data_type type) noexcept
{
    return type >= data_type::integer_16 and type <= data_type::unsigned_32;
}

/// Precondition: is_number(type).
[[nodiscard]] constexpr width width_of(data_type type) noexcept
{
    return type == data_type::integer_32 or type == data_type::unsigned_32 ? width::double_word : width::word;
}

}  // namespace drivecodec::fc
