// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/register_row.hpp>
#include <drivecodec/drives/xd1000/link.hpp>

namespace drivecodec::xd1000 {

namespace detail {

using drives::access;
using drives::no_default;
using drives::no_limits_signed;
using drives::no_limits_unsigned;
using drives::register_row;
using drives::source;
using enum drives::access;
using enum drives::raw_type;
using enum drives::source;

/// A physical value of which the manual prints the display, but neither limits nor the factory setting.
[[nodiscard]] consteval register_row setting(int address, std::string_view name, std::string_view menu,
                                             std::string_view code, int exponent, unit of, source scale_from)
{
    return {static_cast<std::uint16_t>(address), name, menu, code, unsigned_number, static_cast<std::int8_t>(exponent),
            of, scale_from, no_limits_unsigned, no_default, read_write, manual};
}

[[nodiscard]] consteval register_row word_of_bits(int address, std::string_view name, std::string_view code,
                                                  access may, source access_from)
{
    return {static_cast<std::uint16_t>(address), name, "", code, bits, 0, unit::none, manual,
            no_limits_unsigned, no_default, may, access_from};
}

[[nodiscard]] consteval register_row speed(int address, std::string_view name, std::string_view code, access may)
{
    return {static_cast<std::uint16_t>(address), name, "", code, signed_number, 0, unit::revolution_per_minute,
            sister_drive, no_limits_signed, no_default, may, manual};
}

/// Of the communication scanner: the address of the register that is copied to or from a word; 0 is none.
[[nodiscard]] consteval register_row scanner_address(int address, std::string_view name, std::string_view menu,
                                                     std::string_view code, int factory_setting)
{
    return {static_cast<std::uint16_t>(address), name, menu, code, register_address, 0, unit::none, manual,
            no_limits_unsigned, {factory_setting, manual}, read_write_at_standstill, sister_drive};
}

[[nodiscard]] consteval register_row scanner_word(int address, std::string_view name, std::string_view menu,
                                                  std::string_view code, access may)
{
    return {static_cast<std::uint16_t>(address), name, menu, code, bits, 0, unit::none, manual,
            no_limits_unsigned, no_default, may, sister_drive};
}

}  // namespace detail

/// Every register that the manual names, as it prints it. The sister drive is the ATV12, of the same registers.
///
/// Two scales are worth a second look: the manual's only example of ACC, 000Dh for 13 s, makes it whole seconds, where
/// the ATV12 has tenths; and speeds are in rpm there, while this manual has no unit for them.
// clang-format off
inline constexpr auto table = [] {
    using namespace detail;
    return std::array{
        setting(3102, "switching_frequency",      "315",   "",    2,  unit::hertz, manual),
        setting(3103, "maximum_output_frequency", "308",   "",    -1, unit::hertz, manual),
        setting(3104, "high_speed",               "512.2", "HSP", -1, unit::hertz, manual),
        setting(3105, "low_speed",                "512.0", "LSP", -1, unit::hertz, manual),
        word_of_bits(3201, "status_word",          "ETA", read_only, manual),
        word_of_bits(3206, "extended_status_word", "ETI", read_only, sister_drive),
        register_row{6001, "modbus_address",   "701", "", unsigned_number, 0, unit::none, manual,
                     {0, 247, manual}, {0, manual}, read_write, nobody},
        register_row{6003, "baud_rate",        "702", "", enumeration, 0, unit::none, sister_drive,
                     {24, 36, sister_drive}, {32, manual}, read_write, nobody, baud_rate_codes},
        register_row{6004, "character_format", "703", "", enumeration, 0, unit::none, sister_drive,
                     {2, 5, sister_drive}, {3, manual}, read_write, nobody, character_format_codes},
        register_row{6005, "time_out",         "704", "", unsigned_number, -1, unit::second, sister_drive,
                     {1, 300, manual}, {100, manual}, read_write, nobody},
        word_of_bits(8501, "command_word",          "CMD", read_write, manual),
        word_of_bits(8504, "extended_control_word", "CMI", read_write, manual),
        speed(8602, "speed_reference", "LFRD", read_write),
        speed(8604, "speed_feedback",  "RFRD", read_only),
        setting(9001, "acceleration", "", "ACC", 0, unit::second, manual),
        scanner_address(12701, "input_1_source", "705.0", "NMA1", 3201),
        scanner_address(12702, "input_2_source", "705.1", "NMA2", 8604),
        scanner_address(12703, "input_3_source", "705.2", "NMA3", 0),
        scanner_address(12704, "input_4_source", "705.3", "NMA4", 0),
        scanner_address(12721, "output_1_destination", "706.0", "NCA1", 8501),
        scanner_address(12722, "output_2_destination", "706.1", "NCA2", 8602),
        scanner_address(12723, "output_3_destination", "706.2", "NCA3", 0),
        scanner_address(12724, "output_4_destination", "706.3", "NCA4", 0),
        scanner_word(12741, "input_1", "707.0", "NM1", read_only),
        scanner_word(12742, "input_2", "707.1", "NM2", read_only),
        scanner_word(12743, "input_3", "707.2", "NM3", read_only),
        scanner_word(12744, "input_4", "707.3", "NM4", read_only),
        scanner_word(12761, "output_1", "708.0", "NC1", read_write),
        scanner_word(12762, "output_2", "708.1", "NC2", read_write),
        scanner_word(12763, "output_3", "708.2", "NC3", read_write),
        scanner_word(12764, "output_4", "708.3", "NC4", read_write),
    };
}();
// clang-format on

static_assert(strictly_ascending(table, &drives::register_row::address));

/// The register with this address, or nullptr.
[[nodiscard]] constexpr drives::register_row const* find(std::uint16_t address) noexcept
{
    return drives::find(table, address);
}
/// The register with this code ("CMD"), menu number ("512.2") or name ("high_speed"), or nullptr.
[[nodiscard]] constexpr drives::register_row const* find(std::string_view word) noexcept
{
    return drives::find(table, word);
}

}  // namespace drivecodec::xd1000
