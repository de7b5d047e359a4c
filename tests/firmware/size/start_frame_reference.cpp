#include "constant_frame.hpp"

extern std::uint8_t const frame[8];  // what the library makes in start_frame.cpp: named, and not there

void send()
{
    transmit(frame, sizeof frame);
}
