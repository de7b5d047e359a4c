// EXPECT: the_text_has_at_most_so_many_characters
#include <drivecodec/vlt6000.hpp>

using namespace drivecodec;

#ifdef OK
constexpr auto request = vlt6000::parameter<533>.write("PUMP ONE", fc::data_not_valid);
#else
constexpr auto request = vlt6000::parameter<533>.write("PUMP 1234", fc::data_not_valid);
#endif
