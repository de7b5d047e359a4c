#pragma once

#include <cstddef>
#include <cstdint>

// An application that serves sixteen registers. Written twice: server.cpp with the library, server_reference.cpp
// without. server_main.cpp is the world around both. READ_WRITE adds function 23.

constexpr std::size_t register_count = 16;
constexpr std::size_t longest_reply  = 64;

/// Returns the size of the reply; 0 if there is none.
std::size_t serve(std::uint8_t const* request, std::size_t size);

inline std::uint16_t registers[register_count];
inline std::uint8_t  reply[longest_reply];

inline bool exist(unsigned first, unsigned count) { return first + count <= register_count; }
