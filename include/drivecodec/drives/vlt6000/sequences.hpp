// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/vlt6000/control_word.hpp>

// One command each: the word that gives it. VLT 6000 manual, "Control word as per FC protocol".
//
// Every function changes the bits that it names, sets `data_valid`, without which the drive would ignore the word, and
// keeps all others; so `start(select(word, preset_reference::preset_reference_2))`. What the drive makes of a word
// depends on its terminals and on parameters 503 to 508, too: see gating.hpp.

namespace drivecodec::vlt6000 {

/// A ramp stop and nothing else: no brake, no coasting, output not frozen, preset reference 1, setup 1. To begin from.
inline constexpr control_word neutral =
    control_word::of(control_word::no_dc_brake, control_word::no_coasting_stop, control_word::no_quick_stop,
                     control_word::no_freeze_output, control_word::data_valid);

/// The manual's start command, 047F. It selects preset reference 4, since bits 00 and 01 are 1: if that is not what is
/// wanted, `start(neutral)` is 047C.
inline constexpr control_word start_command =
    neutral.with(control_word::start).with(control_word::preset_reference, preset_reference::preset_reference_4);

namespace detail {

[[nodiscard]] constexpr control_word valid(control_word word) noexcept
{
    return word.with(control_word::data_valid);
}

}  // namespace detail

//=== run and stop ===//

/// Bit 06, and bits 02 to 05, which would each prevent it.
[[nodiscard]] constexpr control_word start(control_word word) noexcept
{
    return control_word::from_raw(static_cast<std::uint16_t>(word.raw | neutral.raw)).with(control_word::start);
}

/// Ramp stop: bit 06 at 0, without jog.
///
/// Releases the output, too: bit 06 does not stop a drive whose output is frozen. One that a digital input has frozen
/// goes on; it stops by `coast` or `dc_brake` only.
[[nodiscard]] constexpr control_word stop(control_word word) noexcept
{
    return detail::valid(word)
        .with(control_word::no_freeze_output)
        .without(control_word::start)
        .without(control_word::jog);
}

/// Bit 04 at 0: ramps down by parameter 207, even while bit 06 is 1. To go on: `start`.
///
/// As `stop` it ends a jog, for the manual does not say which of the two wins, and releases the output: quick stop is
/// not among the ways to stop a drive whose output is frozen.
[[nodiscard]] constexpr control_word quick_stop(control_word word) noexcept
{
    return detail::valid(word)
        .with(control_word::no_freeze_output)
        .without(control_word::no_quick_stop)
        .without(control_word::jog);
}

/// Bit 03 at 0: lets go of the motor at once, also with the output frozen. To go on: `start`.
[[nodiscard]] constexpr control_word coast(control_word word) noexcept
{
    return detail::valid(word).without(control_word::no_coasting_stop);
}

/// Bit 02 at 0: brakes to a stop with direct current, also with the output frozen. To go on: `start`.
[[nodiscard]] constexpr control_word dc_brake(control_word word) noexcept
{
    return detail::valid(word).without(control_word::no_dc_brake);
}

//=== frequency ===//

/// Bit 08: the output frequency of parameter 209.
[[nodiscard]] constexpr control_word jog(control_word word) noexcept
{
    return detail::valid(word).with(control_word::jog);
}
[[nodiscard]] constexpr control_word end_jog(control_word word) noexcept
{
    return detail::valid(word).without(control_word::jog);
}

/// Bit 05 at 0: the output frequency stays as it is. Clearing bit 06 will not stop the drive then; `stop` will.
[[nodiscard]] constexpr control_word freeze_output(control_word word) noexcept
{
    return detail::valid(word).without(control_word::no_freeze_output);
}
[[nodiscard]] constexpr control_word release_output(control_word word) noexcept
{
    return detail::valid(word).with(control_word::no_freeze_output);
}

/// Bit 15. A drive from the factory ignores it: parameter 506 is at digital input.
[[nodiscard]] constexpr control_word reverse(control_word word) noexcept
{
    return detail::valid(word).with(control_word::reversing);
}
[[nodiscard]] constexpr control_word end_reverse(control_word word) noexcept
{
    return detail::valid(word).without(control_word::reversing);
}

[[nodiscard]] constexpr control_word select(control_word word, preset_reference wanted) noexcept
{
    return detail::valid(word).with(control_word::preset_reference, wanted);
}
/// Only if multi-setup is the choice of parameter 004.
[[nodiscard]] constexpr control_word select(control_word word, setup wanted) noexcept
{
    return detail::valid(word).with(control_word::setup, wanted);
}

//=== reset of a trip ===//

// By the change of bit 07 from 0 to 1, so by two telegrams: first `prepare_reset`, then `reset`. A word that has the 1
// already resets nothing, however often it is sent. A word that also starts may run the motor as soon as the trip is
// reset: `reset(stop(word))` does not.

/// Bit 07 at 0: before a reset, and after it, ready for the next.
[[nodiscard]] constexpr control_word prepare_reset(control_word word) noexcept
{
    return detail::valid(word).without(control_word::reset);
}

/// Bit 07 at 1, if the drive has received it at 0 before.
[[nodiscard]] constexpr control_word reset(control_word word) noexcept
{
    return detail::valid(word).with(control_word::reset);
}

}  // namespace drivecodec::vlt6000
