// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>
#include <drivecodec/drives/vlt6000/selection.hpp>

#include <array>

// How a command of the control word meets the same command at a terminal. VLT 6000 manual, parameters 503 to 508.

namespace drivecodec::vlt6000 {

/// The choice of parameters 503 to 508: who commands.
enum class gating : std::uint16_t {
    digital_input        = 0,  ///< The terminal alone.
    serial_communication = 1,  ///< The control word alone.
    logic_and            = 2,  ///< Only both together.
    logic_or             = 3,  ///< Either of them.
};

inline constexpr std::array<std::uint16_t, 4> gating_codes{0, 1, 2, 3};

/// Errors: `bad_value` at 0 for a number that is none of the four.
[[nodiscard]] constexpr result<gating> make_gating(std::uint16_t number) noexcept
{
    if (number > static_cast<std::uint16_t>(gating::logic_or)) { return error{errc::bad_value, 0}; }
    return static_cast<gating>(number);
}

/// Parameters 503 to 508 in this order; without arguments, as a drive leaves the factory.
struct gating_settings {
    gating coasting_stop    = gating::logic_or;
    gating dc_brake         = gating::logic_or;
    gating start            = gating::logic_or;
    gating reversing        = gating::digital_input;
    gating setup            = gating::logic_or;
    gating preset_reference = gating::logic_or;

    friend constexpr bool operator==(gating_settings const&, gating_settings const&) noexcept = default;
};

/// What the two sources say of one function: the levels of the terminal and of the control word's bit, as they are on
/// the wire, also where the 0 commands; or one choice of four. Written `{.terminal = true, .bus = false}`.
template <typename Value>
struct sources {
    Value terminal;
    Value bus;
};

namespace detail {

/// Of two signals of which a 1 commands, bit by bit.
[[nodiscard]] constexpr unsigned gate(gating how, unsigned terminal, unsigned bus) noexcept
{
    switch (how) {
    case gating::digital_input: return terminal;
    case gating::serial_communication: return bus;
    case gating::logic_and: return terminal & bus;
    case gating::logic_or: break;
    }
    return terminal | bus;
}

/// Does the level 1, or else the level 0, command it?
[[nodiscard]] constexpr bool is_commanded(gating how, sources<bool> levels, bool active_level) noexcept
{
    return gate(how, levels.terminal == active_level ? 1U : 0U, levels.bus == active_level ? 1U : 0U) != 0;
}

}  // namespace detail

// Precondition of all: the gating is one of the four, as `make_gating` gives it.

/// Parameter 503: does the motor coast, or may it run? Terminal 27 and bit 03, both active at 0: with `logic_or` one 0
/// is enough to coast, with `logic_and` one 1 is enough to run.
[[nodiscard]] constexpr bool is_coasting(gating how, sources<bool> levels) noexcept
{
    return detail::is_commanded(how, levels, false);
}

/// Parameter 504: does the drive brake with DC, or may the motor run? Terminal 19 or 27, and bit 02 (the manual's note
/// says "bit 03", which is the coasting stop), both active at 0, as in `is_coasting`.
[[nodiscard]] constexpr bool is_dc_braking(gating how, sources<bool> levels) noexcept
{
    return detail::is_commanded(how, levels, false);
}

/// Parameter 505: is there a start command, or a stop? Terminal 18 and bit 06, active at 1.
[[nodiscard]] constexpr bool is_started(gating how, sources<bool> levels) noexcept
{
    return detail::is_commanded(how, levels, true);
}

/// Parameter 506: does the motor turn anti-clockwise? Terminal 19 and bit 15, active at 1.
///
/// For `serial_communication`, terminal 0 and bit 1 the manual prints "Clockwise", and "Anti-clock." only where the
/// terminal is 1 as well. That is the row of `logic_and`, against "can only be activated if a command is given via
/// serial communication"; here the bit alone decides.
[[nodiscard]] constexpr bool is_anti_clockwise(gating how, sources<bool> levels) noexcept
{
    return detail::is_commanded(how, levels, true);
}

/// Parameter 507: the setup that is active. Digital inputs and bits 13/14, gated bit by bit.
[[nodiscard]] constexpr setup active_setup(gating how, sources<setup> chosen) noexcept
{
    return static_cast<setup>(
        detail::gate(how, static_cast<unsigned>(chosen.terminal), static_cast<unsigned>(chosen.bus)));
}

/// Parameter 508: the preset reference that is active. Digital inputs and bits 00/01, gated bit by bit.
[[nodiscard]] constexpr preset_reference active_preset_reference(gating how, sources<preset_reference> chosen) noexcept
{
    return static_cast<preset_reference>(
        detail::gate(how, static_cast<unsigned>(chosen.terminal), static_cast<unsigned>(chosen.bus)));
}

}  // namespace drivecodec::vlt6000
