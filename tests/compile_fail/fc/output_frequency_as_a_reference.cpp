// EXPECT: cannot convert|could not convert|no matching|no viable|no known conversion
#include <drivecodec/fc/process.hpp>

using namespace drivecodec::fc;

constexpr auto heard = process_status{}.output_frequency();

#ifdef OK
constexpr auto command = data_valid(0x047F, reference::from_raw(heard.raw()));
#else
constexpr auto command = data_valid(0x047F, heard);
#endif
