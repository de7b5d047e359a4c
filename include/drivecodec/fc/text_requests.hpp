// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/parameter_requests.hpp>
#include <drivecodec/fc/text.hpp>

// Builders of text telegrams; as for parameters, the process data come last.

namespace drivecodec::fc {

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
template <int Most>
void a_text_has_at_most_so_many_characters();
void a_constant_text_ends_with_a_zero_which_is_not_sent();
}  // namespace compile_error

namespace detail {

[[nodiscard]] constexpr ind ind_of(text_access access) noexcept
{
    return ind{}.with(ind::text_access, access);
}

}  // namespace detail

/// Reads a text. On the wire it has four zeros where a value would be.
template <typename Layout = vlt_layout>
[[nodiscard]] constexpr basic_fixed_text_request<Layout, 4> read_text(number_of<Layout>  number,
                                                                      process_of<Layout> process) noexcept
{
    return {number.with(ak_command::text), detail::ind_of(text_access::read), {}, process};
}

/// Writes a text known to the compiler, without the literal's terminating zero; an array without one does not compile.
template <typename Layout = vlt_layout, std::size_t Size>
[[nodiscard]] consteval basic_fixed_text_request<Layout, Size - 1>
write_text(number_of<Layout> number, char const (&text)[Size], process_of<Layout> process)
{
    if (Size - 1 > max_text_size<Layout>) {
        compile_error::a_text_has_at_most_so_many_characters<int{max_text_size<Layout>}>();
    }
    if (text[Size - 1] != '\0') { compile_error::a_constant_text_ends_with_a_zero_which_is_not_sent(); }
    basic_fixed_text_request<Layout, Size - 1> made{
        number.with(ak_command::text), detail::ind_of(text_access::write), {}, process};
    for (std::size_t i = 0; i + 1 < Size; ++i) { made.characters[i] = static_cast<std::uint8_t>(text[i]); }
    return made;
}

/// Writes characters known only at run time, which are borrowed. Errors: `bad_length` at 0 for more than fit.
template <typename Layout = vlt_layout>
[[nodiscard]] constexpr result<basic_text_request<Layout>> make_write_text(number_of<Layout> number, bytes characters,
                                                                           process_of<Layout> process) noexcept
{
    if (characters.size() > max_text_size<Layout>) { return error{errc::bad_length, 0}; }
    return basic_text_request<Layout>{number.with(ak_command::text), detail::ind_of(text_access::write), characters,
                                      process};
}

}  // namespace drivecodec::fc
