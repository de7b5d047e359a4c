// EXPECT: a_text_has_at_most_so_many_characters.*244
#include <drivecodec/fc/text_requests.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr char text[244 + 1]{};
#else
constexpr char text[245 + 1]{};
#endif
constexpr auto asked = write_text(533, text, data_not_valid);
