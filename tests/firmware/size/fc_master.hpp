#pragma once

#include <cstddef>
#include <cstdint>

// An application that runs a drive and reads a parameter of it. Written twice, as client.hpp.

constexpr int parameter = 518;

/// What a drive says of itself.
struct drive_state {
    std::uint16_t status_word;
    std::uint16_t output_frequency;
};

bool control(std::uint16_t control_word, std::uint16_t reference, drive_state* state);
bool read(std::uint16_t control_word, std::uint16_t reference, std::uint16_t* value);

//=== the line ===//

constexpr std::size_t longest_reply = 32;

void        transmit(std::uint8_t const* telegram, std::size_t size);
std::size_t receive(std::uint8_t* reply);  // returns the size of the reply
