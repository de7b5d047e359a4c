// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/parameter.hpp>

// Builders of parameter telegrams. Each takes the process data last: a parameter telegram also controls the drive.
//
//     encode(address::short_format(1), read_value(202, data_not_valid))
//     encode(address::short_format(1), write_word(202, 1000, storage::ram_and_eeprom, data_not_valid))

namespace drivecodec::fc {

/// Where a value is written to. EEPROM survives a power failure, and wears out.
enum class storage : std::uint8_t { ram, ram_and_eeprom };

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
void a_word_must_be_between_minus_32768_and_65535();
void an_array_index_must_be_between_0_and_255();
}  // namespace compile_error

/// 16 bits to write, from a signed or an unsigned number: which of the two the parameter has is not told.
struct word_value {
    std::uint16_t raw;

    /// A constant; one that has no 16 bits does not compile. Of its own type: 0xFFFF'FFFF as an int would be -1.
    template <std::integral T>
        requires(sizeof(T) > 2)
    consteval word_value(T number) : raw{static_cast<std::uint16_t>(number)}
    {
        if (number > T{0xFFFF} or (std::is_signed_v<T> and number < static_cast<T>(-0x8000))) {
            compile_error::a_word_must_be_between_minus_32768_and_65535();
        }
    }
    template <parameter_integer T>
        requires(sizeof(T) <= 2)
    constexpr word_value(T number) noexcept : raw{static_cast<std::uint16_t>(number)}
    {}
};

/// The element of an array: the low byte of IND.
struct array_index_value {
    std::uint8_t raw;

    /// A constant; one beyond a byte does not compile.
    template <std::integral T>
        requires(sizeof(T) > 1)
    consteval array_index_value(T number) : raw{static_cast<std::uint8_t>(number)}
    {
        if (number < T{0} or number > T{0xFF}) { compile_error::an_array_index_must_be_between_0_and_255(); }
    }
    constexpr array_index_value(std::same_as<std::uint8_t> auto number) noexcept : raw{number} {}
};

/// 32 bits to write.
struct double_word_value {
    std::uint32_t raw;

    template <parameter_integer T>
    constexpr double_word_value(T number) noexcept : raw{static_cast<std::uint32_t>(number)}
    {}
};

// The layout is given, not deduced, so that `data_not_valid` and constants become what it has.
template <typename Layout>
using process_of = std::type_identity_t<basic_process_command<Layout>>;
template <typename Layout>
using number_of = std::type_identity_t<basic_parameter_number<Layout>>;

/// AK, PNU, IND and PWE as given: for commands that no other function here makes.
template <typename Layout = vlt_layout>
[[nodiscard]] constexpr basic_parameter_request<Layout> any_command(ak_command command, number_of<Layout> number,
                                                                    ind index, std::uint32_t pwe,
                                                                    process_of<Layout> process) noexcept
{
    return {number.with(command), index, pwe, process};
}

/// Nothing of a parameter: the process data alone, in a telegram with room for one.
template <typename Layout = vlt_layout>
[[nodiscard]] constexpr basic_parameter_request<Layout> no_command(process_of<Layout> process) noexcept
{
    return {{}, {}, 0, process};
}

/// Reads a parameter; the reply says whether it is a word or a double word.
template <typename Layout = vlt_layout>
[[nodiscard]] constexpr basic_parameter_request<Layout> read_value(number_of<Layout>  number,
                                                                   process_of<Layout> process) noexcept
{
    return any_command<Layout>(ak_command::read_value, number, {}, 0, process);
}

/// Reads one element of an array, such as 615.
template <typename Layout = vlt_layout>
[[nodiscard]] constexpr basic_parameter_request<Layout>
read_value(number_of<Layout> number, array_index_value array_index, process_of<Layout> process) noexcept
{
    return any_command<Layout>(ak_command::read_value, number, ind::from_raw(array_index.raw), 0, process);
}

template <typename Layout = vlt_layout>
[[nodiscard]] constexpr basic_parameter_request<Layout> write_word(number_of<Layout> number,
                                                                   array_index_value array_index, word_value contents,
                                                                   storage where, process_of<Layout> process) noexcept
{
    auto const command = where == storage::ram ? ak_command::write_word : ak_command::write_word_to_eeprom;
    return any_command<Layout>(command, number, ind::from_raw(array_index.raw), contents.raw, process);
}
template <typename Layout = vlt_layout>
[[nodiscard]] constexpr basic_parameter_request<Layout> write_word(number_of<Layout> number, word_value contents,
                                                                   storage where, process_of<Layout> process) noexcept
{
    return write_word<Layout>(number, 0, contents, where, process);
}

template <typename Layout = vlt_layout>
[[nodiscard]] constexpr basic_parameter_request<Layout>
write_double_word(number_of<Layout> number, array_index_value array_index, double_word_value contents, storage where,
                  process_of<Layout> process) noexcept
{
    auto const command =
        where == storage::ram ? ak_command::write_double_word : ak_command::write_double_word_to_eeprom;
    return any_command<Layout>(command, number, ind::from_raw(array_index.raw), contents.raw, process);
}
template <typename Layout = vlt_layout>
[[nodiscard]] constexpr basic_parameter_request<Layout> write_double_word(number_of<Layout> number,
                                                                          double_word_value contents, storage where,
                                                                          process_of<Layout> process) noexcept
{
    return write_double_word<Layout>(number, 0, contents, where, process);
}

}  // namespace drivecodec::fc
