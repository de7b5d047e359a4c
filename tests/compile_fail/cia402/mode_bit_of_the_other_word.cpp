// EXPECT: cannot convert|no matching|no viable|could not convert|no known conversion
#include <drivecodec/cia402.hpp>

using namespace drivecodec::cia402;

#ifdef OK
constexpr auto no = control_word{}.with(profile_position::new_set_point);
#else
constexpr auto no = control_word{}.with(profile_position::set_point_acknowledge);
#endif
