#include "constant_frame.hpp"

static bool was_right = false;

void transmit(std::uint8_t const* frame, std::size_t size)
{
    constexpr std::uint8_t expected[] = {0x07, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x74, 0x71};

    was_right = size == sizeof expected;
    for (std::size_t i = 0; i < size; ++i) { was_right = was_right and frame[i] == expected[i]; }
}

int main()
{
    send();
    return was_right ? 0 : 1;
}
