#include "state.hpp"

// What the library does in state.cpp. Called, and not there.
int decode_state(std::uint16_t status);

int state_of(std::uint16_t status)
{
    return decode_state(status);
}
