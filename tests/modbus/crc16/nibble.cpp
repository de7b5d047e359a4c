#include <drivecodec/modbus/crc16/nibble.hpp>

#include "support/crc16_algorithm.hpp"

INSTANTIATE_TYPED_TEST_SUITE_P(nibble, crc16_algorithm, drivecodec::modbus::crc16::nibble);
