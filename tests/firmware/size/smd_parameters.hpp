#pragma once

#include <cstddef>
#include <cstdint>

// An application that sets three parameters of an smd drive, whose registers the compiler knows. Written twice, as
// client.hpp.

void send();
void transmit(std::uint8_t const* frame, std::size_t size);
