#include "fc_constant_telegram.hpp"

extern std::uint8_t const start[16];  // what the library makes in fc_constant_telegram.cpp: named, and not there

void send()
{
    transmit(start, sizeof start);
}
