#include "smd_parameters.hpp"

extern std::uint8_t const acceleration[8];  // what the library makes in smd_parameters.cpp: named, and not there
extern std::uint8_t const mode[8];
extern std::uint8_t const fault_time[8];

void send()
{
    transmit(acceleration, sizeof acceleration);
    transmit(mode, sizeof mode);
    transmit(fault_time, sizeof fault_time);
}
