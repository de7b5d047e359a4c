#pragma once

#include <drivecodec/cia402/machine.hpp>

/// A drive that was led into this state by the usual words, the last of which had no reset.
[[nodiscard]] constexpr drivecodec::cia402::machine drive_in(drivecodec::cia402::state             wanted,
                                                             drivecodec::cia402::machine::settings chosen = {})
{
    using namespace drivecodec::cia402;

    machine drive{chosen};
    if (wanted == state::not_ready_to_switch_on) { return drive; }
    drive.initialised();
    if (wanted >= state::fault_reaction_active) { drive.fault(); }
    if (wanted == state::fault) { drive.fault_handled(); }
    if (wanted >= state::fault_reaction_active) { return drive; }
    for (auto const raw : std::array<std::uint16_t, 4>{0x0006, 0x0007, 0x000F, 0x0002}) {
        if (drive.state() != wanted) { drive.receive(control_word::from_raw(raw)); }
    }
    return drive;
}
