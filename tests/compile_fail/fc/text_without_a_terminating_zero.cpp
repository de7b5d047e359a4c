// EXPECT: a_constant_text_ends_with_a_zero_which_is_not_sent
#include <drivecodec/fc/text_requests.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr char text[6]{'H', 'E', 'L', 'L', 'O'};
#else
constexpr char text[5]{'H', 'E', 'L', 'L', 'O'};
#endif
constexpr auto asked = write_text(533, text, data_not_valid);
