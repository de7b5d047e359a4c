#pragma once

#include <cstddef>
#include <cstdint>

// An application that reads three registers of a drive, and sets one. Written twice: client.cpp with the library,
// client_reference.cpp without. client_main.cpp is the world around both.

constexpr std::size_t polled_count = 3;

bool poll(std::uint16_t* values);
bool set(std::uint16_t address, std::uint16_t value);

//=== the line ===//

constexpr std::size_t longest_reply = 32;

void        transmit(std::uint8_t const* frame, std::size_t size);
std::size_t receive(std::uint8_t* reply);  // returns the size of the reply
