// EXPECT: file_record_length_must_be_between.*1.*124
#include <drivecodec/modbus/file_record_range.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr file_record_range range{1, 0, 124};
#else
constexpr file_record_range range{1, 0, 125};
#endif
