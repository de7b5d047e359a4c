#include <drivecodec/modbus/crc16/slices.hpp>

#include "support/crc16_algorithm.hpp"

INSTANTIATE_TYPED_TEST_SUITE_P(slices, crc16_algorithm, drivecodec::modbus::crc16::slices);
