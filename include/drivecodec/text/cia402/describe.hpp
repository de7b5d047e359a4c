// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/command.hpp>
#include <drivecodec/text/cia402/names.hpp>
#include <drivecodec/text/writer.hpp>

#include <array>

namespace drivecodec::cia402 {

namespace detail {

template <typename Word>
struct flag_name {
    flag<Word>       bit;
    std::string_view name;
};

/// Those of the flags that are set, and what is left in hexadecimal.
template <typename Word, std::size_t N>
constexpr void write_flags(text_writer& out, Word word, std::array<flag_name<Word>, N> const& names) noexcept
{
    for (auto const& each : names) {
        if (word.test(each.bit)) { out.put(' ').put(each.name); }
        word = word.without(each.bit);
    }
    if (word.raw != 0) { out.put(" +").hex(word.raw); }
}

}  // namespace detail

/// `0637 operation_enabled voltage_enabled remote target_reached`; of a word that is no state, `0002 no_state`.
constexpr void write_text(text_writer& out, status_word status) noexcept
{
    auto const found = decode_state(status);
    out.hex(status.raw).put(' ').put(found ? to_string(*found) : "no_state");

    constexpr std::uint16_t state_bits = 0x006F;
    constexpr std::array    names{
        detail::flag_name<status_word>{status_word::voltage_enabled, "voltage_enabled"},
        detail::flag_name<status_word>{status_word::warning, "warning"},
        detail::flag_name<status_word>{status_word::remote, "remote"},
        detail::flag_name<status_word>{status_word::target_reached, "target_reached"},
        detail::flag_name<status_word>{status_word::internal_limit_active, "internal_limit_active"},
    };
    detail::write_flags(out, status_word::from_raw(static_cast<std::uint16_t>(status.raw & ~state_bits)), names);
}

/// `010F enable_operation halt`, as a drive in the state `present` understands it: 0007 has two names.
constexpr void write_text(text_writer& out, control_word word, state present = state::switch_on_disabled) noexcept
{
    out.hex(word.raw).put(' ').put(to_string(decode_command(word, present)));

    constexpr std::array names{
        detail::flag_name<control_word>{control_word::fault_reset, "fault_reset"},
        detail::flag_name<control_word>{control_word::halt, "halt"},
    };
    auto const others = static_cast<std::uint16_t>(word.raw & (0x0080U | static_cast<unsigned>(~command_bits)));
    detail::write_flags(out, control_word::from_raw(others), names);
}

/// The same into the caller's characters; ends with "..." if it does not fit.
[[nodiscard]] constexpr std::string_view describe(status_word status, std::span<char> out) noexcept
{
    text_writer text{out};
    write_text(text, status);
    return text.view_with_ellipsis();
}
[[nodiscard]] constexpr std::string_view describe(control_word word, std::span<char> out,
                                                  state present = state::switch_on_disabled) noexcept
{
    text_writer text{out};
    write_text(text, word, present);
    return text.view_with_ellipsis();
}

}  // namespace drivecodec::cia402
