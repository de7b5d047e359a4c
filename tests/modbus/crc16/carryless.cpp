#include <drivecodec/modbus/crc16/carryless.hpp>

#include "support/crc16_algorithm.hpp"

INSTANTIATE_TYPED_TEST_SUITE_P(carryless, crc16_algorithm, drivecodec::modbus::crc16::carryless);

// Native code is tested where the compiler's target has it: -mpclmul, -march=armv8-a+crypto.
#if defined(__PCLMUL__)
static_assert(drivecodec::modbus::crc16::carryless::is_native);
#elif not defined(__aarch64__)
static_assert(not drivecodec::modbus::crc16::carryless::is_native);
#endif
