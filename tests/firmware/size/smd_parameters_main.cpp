#include "smd_parameters.hpp"

static unsigned right = 0;

// Address, function and register of each frame, and its value; not the checksum.
void transmit(std::uint8_t const* frame, std::size_t size)
{
    constexpr std::uint8_t expected[3][6] = {
        {5, 6, 0, 61, 0, 50},
        {5, 6, 0, 63, 0, 2},
        {5, 6, 0, 133, 0, 100},
    };

    auto is_right = size == 8 and right < 3;
    for (std::size_t i = 0; is_right and i < sizeof expected[0]; ++i) { is_right = frame[i] == expected[right][i]; }
    if (is_right) { ++right; }
}

int main()
{
    send();
    return right == 3 ? 0 : 1;
}
