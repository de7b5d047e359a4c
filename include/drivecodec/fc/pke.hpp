// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>
#include <drivecodec/core/word.hpp>
#include <drivecodec/fc/data_layout.hpp>

// The first two words of a parameter block. VLT 6000 manual, "Parameter bytes".

namespace drivecodec::fc {

/// AK from master to slave. Any of the 16 may come.
enum class ak_command : std::uint8_t {
    no_command                  = 0x0,
    read_value                  = 0x1,
    write_word                  = 0x2,  ///< To RAM.
    write_double_word           = 0x3,  ///< To RAM.
    read_description            = 0x4,  ///< Newer FC guides; IND says which attribute.
    write_double_word_to_eeprom = 0xD,  ///< To RAM and EEPROM.
    write_word_to_eeprom        = 0xE,  ///< To RAM and EEPROM.
    text                        = 0xF,  ///< Read or write, as IND says.
};

/// AK from slave to master. Any of the 16 may come.
enum class ak_reply : std::uint8_t {
    no_reply           = 0x0,
    word               = 0x1,
    double_word        = 0x2,
    description        = 0x3,  ///< Newer FC guides.
    cannot_be_executed = 0x7,  ///< The error number is in PWE.
    text               = 0xF,
};

/// PKE: what is asked or answered, and of which parameter. AK reads as a command or as a reply: only the direction of
/// the telegram tells which.
struct pke : word<pke, std::uint16_t> {
    static constexpr field<pke, ak_command, 12, 4>    command{};
    static constexpr field<pke, ak_reply, 12, 4>      reply{};
    static constexpr field<pke, std::uint16_t, 0, 11> number_of_11_bits{};
    static constexpr field<pke, std::uint16_t, 0, 12> number_of_12_bits{};
    /// Not used by the VLT 6000; the highest bit of the parameter number in newer guides.
    static constexpr flag<pke> bit_11{11};

    /// The parameter number (PNU).
    template <typename Layout = vlt_layout>
    [[nodiscard]] constexpr std::uint16_t number() const noexcept
    {
        return Layout::parameter_number_bits == 12 ? get(number_of_12_bits) : get(number_of_11_bits);
    }
};

/// How a text command uses IND.
enum class text_access : std::uint8_t { none = 0x00, read = 0x04, write = 0x05 };

/// IND: the element of an array; with AK F in the high byte whether a text is read or written.
struct ind : word<ind, std::uint16_t> {
    static constexpr field<ind, std::uint8_t, 0, 8>    array_index{};
    static constexpr field<ind, fc::text_access, 8, 8> text_access{};
};

namespace compile_error {
// Declared, never defined, not constexpr: calling it is how a consteval function says no.
template <int Last>
void parameter_number_must_be_between_0_and();
}  // namespace compile_error

/// A parameter number (PNU) that the layout has bits for: 0 to 2047, or to 4095.
template <typename Layout>
class basic_parameter_number {
public:
    static constexpr std::uint16_t last = (1U << Layout::parameter_number_bits) - 1U;

    consteval basic_parameter_number(long long number) : number_{static_cast<std::uint16_t>(number)}
    {
        if (number < 0 or number > last) { compile_error::parameter_number_must_be_between_0_and<last>(); }
    }

    /// Of a number known only at run time. Errors: `bad_value` at 0.
    [[nodiscard]] static constexpr result<basic_parameter_number> make(std::uint16_t number) noexcept
    {
        if (number > last) { return error{errc::bad_value, 0}; }
        return basic_parameter_number{number, checked{}};
    }

    [[nodiscard]] constexpr std::uint16_t number() const noexcept { return number_; }

    /// PKE with this number and command; bit 11 is 0 where it is no part of the number.
    [[nodiscard]] constexpr pke with(ak_command command) const noexcept
    {
        return pke::from_raw(number_).with(pke::command, command);
    }

    friend constexpr bool operator==(basic_parameter_number, basic_parameter_number) noexcept = default;

private:
    struct checked {};
    constexpr basic_parameter_number(std::uint16_t number, checked) noexcept : number_{number} {}

    std::uint16_t number_;
};
using parameter_number = basic_parameter_number<vlt_layout>;

}  // namespace drivecodec::fc
