#pragma once

#include <cstdint>

// What an image may use of its surroundings; startup.cpp defines it.
namespace firmware {

/// Writes a text to the debugger's, or the emulator's, console.
void write(char const* text) noexcept;

/// Ends the emulator with this exit status. Returning from main() does the same.
[[noreturn]] void exit(std::uint32_t status) noexcept;

}  // namespace firmware
