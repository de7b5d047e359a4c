#include "fc_constant_telegram.hpp"

#include <drivecodec/fc.hpp>

using namespace drivecodec::fc;
using namespace drivecodec::literals;

constexpr auto start =
    encode(address::short_format(1), write_word(202, 1000, storage::ram_and_eeprom, data_valid(0x047F, 50_percent)));

void send()
{
    transmit(start.data(), start.size());
}
