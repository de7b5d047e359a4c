// EXPECT: no matching|could not convert|cannot convert|no viable|private
#include <drivecodec/fc/parameter_requests.hpp>

using namespace drivecodec::fc;
using namespace drivecodec::literals;

#ifdef OK
constexpr process_command command = data_valid(0x047F, 50_percent);
#else
constexpr process_command command{0x047F, 50_percent};
#endif
