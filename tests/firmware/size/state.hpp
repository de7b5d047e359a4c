#pragma once

#include <cstdint>

// An application that must know in which state a drive is. Written twice, as client.hpp.

/// The number of the state that a statusword tells, or -1.
int state_of(std::uint16_t status);
