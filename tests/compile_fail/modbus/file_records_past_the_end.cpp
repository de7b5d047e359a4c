// EXPECT: file_records_must_end_at_or_before_record_9999
#include <drivecodec/modbus/file_record_range.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr file_record_range range{1, 9998, 2};
#else
constexpr file_record_range range{1, 9999, 2};
#endif
