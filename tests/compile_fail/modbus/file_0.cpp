// EXPECT: file_number_must_be_between_1_and_65535
#include <drivecodec/modbus/file_record_range.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr file_record_range range{1, 0, 1};
#else
constexpr file_record_range range{0, 0, 1};
#endif
