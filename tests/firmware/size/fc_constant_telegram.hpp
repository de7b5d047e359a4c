#pragma once

#include <cstddef>
#include <cstdint>

// An application that sends one telegram which never changes. Written twice, as client.hpp.

void send();
void transmit(std::uint8_t const* telegram, std::size_t size);
