// EXPECT: read_device_id_code_must_be_between_1_and_4
#include <drivecodec/modbus/functions/read_device_identification.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr read_device_identification::request asked{static_cast<read_device_id_code>(4), 0};
#else
constexpr read_device_identification::request asked{static_cast<read_device_id_code>(5), 0};
#endif
