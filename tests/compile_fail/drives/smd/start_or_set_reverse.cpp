// EXPECT: no match for .*operator|invalid operands
#include <drivecodec/drives/smd/command.hpp>

using namespace drivecodec::smd;

#ifdef OK
constexpr auto no = control_word(command::start);
#else
constexpr auto no = control_word(command::start | command::set_reverse);
#endif
