// EXPECT: an_array_index_must_be_between_0_and_255
#include <drivecodec/fc/parameter_requests.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto asked = write_word(615, 1, 1, storage::ram, data_not_valid);
#else
constexpr auto asked = write_word(615, -1, 1, storage::ram, data_not_valid);
#endif
