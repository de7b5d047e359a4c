// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/table.hpp>
#include <drivecodec/drives/value.hpp>

#include <span>
#include <string_view>

namespace drivecodec::drives {

/// How the 16 bits of a register are to be read.
enum class raw_type : std::uint8_t {
    unsigned_number,
    signed_number,
    bits,
    enumeration,
    register_address,
    two_bytes,  ///< Two numbers, of which the first is the high byte.
    text,       ///< ASCII, two characters a register.
};

/// Where a fact is from.
///
/// Not the same as whether it is stated (`stated` of the VLT 6000): here every row has limits, if only those of its
/// type, so that a check asks nothing, and another manual may have a fact; there, most of it is in no manual, and no
/// number would be true.
enum class source : std::uint8_t {
    manual,        ///< The drive's own manual says it.
    sister_drive,  ///< Only the manual of a drive of the same make says it: unverified.
    nobody,        ///< It is not stated; what stands there is what the type allows, or 0.
};

/// The least and the greatest raw number.
struct raw_limits {
    std::int32_t min;
    std::int32_t max;
    source       from;
};
inline constexpr raw_limits no_limits_unsigned{0, 0xFFFF, source::nobody};
inline constexpr raw_limits no_limits_signed{-0x8000, 0x7FFF, source::nobody};

/// The raw number a drive leaves the factory with.
struct raw_default {
    std::int32_t number;
    source       from;
};
inline constexpr raw_default no_default{0, source::nobody};

/// A register as the manual prints it: what it does not print is left out. A physical value is the raw number x
/// 10^exponent of its unit.
struct register_row {
    std::uint16_t    address;
    std::string_view name{};
    std::string_view menu{};  ///< On the drive's display: "315", "512.2". Empty if it is in no menu.
    std::string_view code{};  ///< The drive's own short name: "CMD". Empty if it has none.
    raw_type         type            = raw_type::unsigned_number;
    std::int8_t      exponent        = 0;
    drivecodec::unit unit            = drivecodec::unit::none;
    source           scale_from      = source::nobody;  ///< Of type, exponent and unit.
    raw_limits       limits          = no_limits_unsigned;
    raw_default      factory_setting = no_default;
    drives::access   access          = drives::access::unknown;
    source           access_from     = source::nobody;

    /// Of an enumeration, or of bits of which only some may be sent: all that there are, within the limits. Empty for
    /// all else.
    std::span<std::uint16_t const> choices{};

    [[nodiscard]] constexpr bool is_readable() const noexcept { return drives::is_readable(access); }
    [[nodiscard]] constexpr bool is_writable() const noexcept { return drives::is_writable(access); }

    /// The 16 bits as the number they stand for.
    [[nodiscard]] constexpr std::int32_t number(std::uint16_t raw) const noexcept
    {
        return type == raw_type::signed_number ? static_cast<std::int16_t>(raw) : std::int32_t{raw};
    }

    /// Is the number one that the register can have? Errors: `out_of_range` at 0.
    [[nodiscard]] constexpr error check(std::int32_t wanted) const noexcept
    {
        auto const is_choice = choices.empty() or is_one_of(choices, wanted);
        return wanted < limits.min or wanted > limits.max or not is_choice ? error{errc::out_of_range, 0} : error{};
    }

    /// The 16 bits of a physical value. Errors, at 0: `inexact`, `out_of_range`.
    [[nodiscard]] constexpr result<std::uint16_t> make_raw(decimal value) const noexcept
    {
        auto const wanted = value.scaled_to(exponent);
        if (not wanted) { return wanted.error(); }
        if (auto const fault = check(*wanted); not fault.ok()) { return fault; }
        return static_cast<std::uint16_t>(*wanted);
    }

    /// May these 16 bits be written? Errors, at 0: `read_only`, `out_of_range`.
    [[nodiscard]] constexpr error check_write(std::uint16_t raw) const noexcept
    {
        return is_writable() ? check(number(raw)) : error{errc::read_only, 0};
    }
};

template <std::size_t N>
using register_table = std::array<register_row, N>;

/// The register with this address, or nullptr.
template <std::size_t N>
[[nodiscard]] constexpr register_row const* find(register_table<N> const& table, std::uint16_t address) noexcept
{
    return find_row(table, &register_row::address, address);
}

/// The one register with this code, menu number or name, or nullptr: also for a word that several have.
template <std::size_t N>
[[nodiscard]] constexpr register_row const* find(register_table<N> const& table, std::string_view word) noexcept
{
    return find_word(table, word, &register_row::code, &register_row::menu, &register_row::name);
}

/// Are these registers all there? Errors: `bad_address`; the offset is that of the first that is not, counted in
/// registers.
template <std::size_t N>
[[nodiscard]] constexpr error check_range(register_table<N> const& table, std::uint16_t first,
                                          std::size_t count) noexcept
{
    for (std::size_t i = 0; i < count; ++i) {
        if (first + i > 0xFFFF or find(table, static_cast<std::uint16_t>(first + i)) == nullptr) {
            return {errc::bad_address, i};
        }
    }
    return {};
}

/// May these values be written there? Errors: `bad_address`, `read_only`, `out_of_range`; the offset is that of the
/// first register that refuses, counted in registers.
template <std::size_t N, typename Values>
[[nodiscard]] constexpr error check_write(register_table<N> const& table, std::uint16_t first,
                                          Values const& values) noexcept
{
    if (auto const fault = check_range(table, first, values.size()); not fault.ok()) { return fault; }
    for (std::size_t i = 0; i < values.size(); ++i) {
        auto const fault = find(table, static_cast<std::uint16_t>(first + i))->check_write(values[i]);
        if (not fault.ok()) { return fault.moved_by(i); }
    }
    return {};
}

}  // namespace drivecodec::drives
