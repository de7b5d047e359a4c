// EXPECT: pattern_must_be_made_of_0_1_x_and_have_exactly_this_many_bits
#include <drivecodec/core/pattern.hpp>

using namespace drivecodec;

#ifdef OK
constexpr pattern_8 coding = "x01x 0001";
#else
constexpr pattern_8 coding = "x01x 0002";
#endif
