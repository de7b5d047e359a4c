#include <drivecodec/modbus/crc16/bitwise.hpp>

#include "support/crc16_algorithm.hpp"

INSTANTIATE_TYPED_TEST_SUITE_P(bitwise, crc16_algorithm, drivecodec::modbus::crc16::bitwise);
