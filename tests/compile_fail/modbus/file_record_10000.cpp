// EXPECT: record_number_must_be_between_0_and_9999
#include <drivecodec/modbus/file_record_range.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr file_record_range range{1, 9999, 1};
#else
constexpr file_record_range range{1, 10000, 1};
#endif
