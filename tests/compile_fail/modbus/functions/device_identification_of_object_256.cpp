// EXPECT: device_object_id_must_be_between_0_and_255
#include <drivecodec/modbus/functions/read_device_identification.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr read_device_identification::request asked{read_device_id_code::specific, 255};
#else
constexpr read_device_identification::request asked{read_device_id_code::specific, 256};
#endif
