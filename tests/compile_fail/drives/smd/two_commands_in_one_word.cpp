// EXPECT: only_one_command_can_be_sent_at_a_time
#include <drivecodec/drives/smd/command.hpp>

using namespace drivecodec::smd;

#ifdef OK
constexpr auto no = control_word(command{0x0008});
#else
constexpr auto no = control_word(command{0x0008 | 0x0040});
#endif
