// EXPECT: a deframer's Capacity is at least the longest frame and two bytes, at most 65535
#include <drivecodec/modbus/rtu/reader.hpp>

using namespace drivecodec::modbus;

#ifdef OK
rtu::basic_reader<public_functions, crc16::by_default, 65'535> reader;
#else
rtu::basic_reader<public_functions, crc16::by_default, 65'536> reader;
#endif
