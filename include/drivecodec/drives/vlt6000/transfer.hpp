// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/vlt6000/parameter_row.hpp>
#include <drivecodec/fc/conversion.hpp>
#include <drivecodec/fc/parameter.hpp>

namespace drivecodec::vlt6000 {

/// Does this index stand for that power of ten? 74 and other indexes of times do not.
[[nodiscard]] constexpr bool is_power_of_ten(int conversion_index) noexcept
{
    if (conversion_index < -128 or conversion_index > 127) { return false; }
    auto const factor = fc::conversion(static_cast<std::int8_t>(conversion_index));
    return factor and *factor == fc::conversion_factor{.index = factor->index, .exponent = factor->index};
}

/// How a value lies in PWE, as far as it is known: because the manual states it, or the user.
struct transfer {
    stated<fc::width>     width{};
    stated<fc::data_type> data_type{};
    stated<std::int8_t>   conversion_index{};

    /// As the manual states it.
    [[nodiscard]] static constexpr transfer of(parameter_row const& row) noexcept
    {
        return {row.width, row.data_type, row.conversion_index};
    }

    /// As the user states it. Preconditions: fc::is_number(type), is_power_of_ten(conversion_index) if it is said.
    [[nodiscard]] static constexpr transfer as(fc::data_type type, stated<int> conversion_index) noexcept
    {
        transfer said{.width = fc::width_of(type), .data_type = type};
        if (conversion_index) { said.conversion_index = static_cast<std::int8_t>(*conversion_index); }
        return said;
    }

    friend constexpr bool operator==(transfer const&, transfer const&) noexcept = default;
};

/// The least and the greatest number that can be transferred so. Where nobody states the sign, only what a signed and an
/// unsigned number have in common. Of 32 bits without a sign, no more than `decimal` has.
struct number_limits {
    std::int32_t min;
    std::int32_t max;
};
[[nodiscard]] constexpr number_limits limits_of(transfer const& how) noexcept
{
    auto const is_word = how.width.value == fc::width::word;
    auto const common  = number_limits{0, is_word ? 0x7FFF : 0x7FFFFFFF};
    if (not how.data_type) { return common; }
    switch (*how.data_type) {
    case fc::data_type::unsigned_8: return {0, 0xFF};
    case fc::data_type::unsigned_16: return {0, 0xFFFF};
    case fc::data_type::integer_16: return {-0x8000, 0x7FFF};
    case fc::data_type::integer_32: return {-0x7FFFFFFF - 1, 0x7FFFFFFF};
    default: return common;
    }
}

/// PWE of a number. Errors: `out_of_range` at 0.
[[nodiscard]] constexpr result<std::uint32_t> pwe_for(std::int32_t number, transfer const& how) noexcept
{
    auto const limits = limits_of(how);
    if (number < limits.min or number > limits.max) { return error{errc::out_of_range, 0}; }
    auto const bits = static_cast<std::uint32_t>(number);
    return how.width.value == fc::width::word ? bits & 0xFFFFU : bits;
}

/// The number in PWE. Errors, at 0: those of `fc::parameter_response::value`; `out_of_range` beyond `limits_of`.
[[nodiscard]] constexpr result<std::int32_t> number_in(fc::parameter_response const& given,
                                                       transfer const&               how) noexcept
{
    auto const width = fc::width_of(given.reply());
    if (not width) { return width.error(); }
    auto const is_word = *width == fc::width::word;
    auto const unsaid  = is_word ? fc::data_type::unsigned_16 : fc::data_type::unsigned_32;
    auto const number  = given.value(how.data_type ? *how.data_type : unsaid);
    if (not number) { return number.error(); }
    // Of what is read, AK tells the width.
    auto const limits = limits_of(how.data_type ? how : transfer{.width = *width});
    if (*number < limits.min or *number > limits.max) { return error{errc::out_of_range, 0}; }
    return static_cast<std::int32_t>(*number);
}

/// The bits in PWE, from a word or a double word. Errors, at 0: `bad_value` where there is no value, `out_of_range` for
/// more than `width` bits.
[[nodiscard]] constexpr result<std::uint32_t> bits_in(fc::parameter_response const& given, std::size_t width) noexcept
{
    auto const transferred = fc::width_of(given.reply());
    if (not transferred) { return transferred.error(); }
    if (width < 32 and given.pwe >> width != 0) { return error{errc::out_of_range, 0}; }
    return given.pwe;
}

}  // namespace drivecodec::vlt6000
