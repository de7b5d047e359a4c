#include "constant_frame.hpp"

static bool was_right = false;

void transmit(std::uint8_t const* frame, std::size_t size)
{
    constexpr std::uint8_t expected[] = {0x02, 0x06, 0x21, 0x35, 0x00, 0x0F, 0xD3, 0xCF};

    was_right = size == sizeof expected;
    for (std::size_t i = 0; i < size; ++i) { was_right = was_right and frame[i] == expected[i]; }
}

int main()
{
    send();
    return was_right ? 0 : 1;
}
