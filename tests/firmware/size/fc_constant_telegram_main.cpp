#include "fc_constant_telegram.hpp"

static bool was_right = false;

void transmit(std::uint8_t const* telegram, std::size_t size)
{
    constexpr std::uint8_t expected[] = {0x02, 0x0E, 0x01, 0xE0, 0xCA, 0x00, 0x00, 0x00,
                                         0x00, 0x03, 0xE8, 0x04, 0x7F, 0x20, 0x00, 0x97};

    was_right = size == sizeof expected;
    for (std::size_t i = 0; i < size; ++i) { was_right = was_right and telegram[i] == expected[i]; }
}

int main()
{
    send();
    return was_right ? 0 : 1;
}
