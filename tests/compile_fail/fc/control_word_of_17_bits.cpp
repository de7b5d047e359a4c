// EXPECT: a_control_word_must_be_between_0_and_FFFF
#include <drivecodec/fc/process.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto process = data_valid(0x047F, {});
#else
constexpr auto process = data_valid(0x1047F, {});
#endif
