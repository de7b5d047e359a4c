#include <drivecodec/modbus/crc16/byte_table.hpp>

#include "support/crc16_algorithm.hpp"

INSTANTIATE_TYPED_TEST_SUITE_P(byte_table, crc16_algorithm, drivecodec::modbus::crc16::byte_table);
