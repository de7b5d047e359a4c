#pragma once

#include <cstdint>

// An application that keeps a drive in the state that its user wants, and resets its faults if the user says so.
// Written twice, as client.hpp.

/// Until the user wants to end it. Returns whether the drive then was where it should be.
bool run(std::uint16_t other_bits);

//=== the user ===//

constexpr std::uint8_t end = 0;

std::uint8_t wanted_goal();  // the number of a state, or `end`
bool         wants_reset();

//=== the line ===//

std::uint16_t read_status();
void          write_control(std::uint16_t word);
