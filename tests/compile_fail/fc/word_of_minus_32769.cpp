// EXPECT: a_word_must_be_between_minus_32768_and_65535
#include <drivecodec/fc/parameter_requests.hpp>

using namespace drivecodec::fc;

#ifdef OK
constexpr auto asked = write_word(202, -32768, storage::ram, data_not_valid);
#else
constexpr auto asked = write_word(202, -32769, storage::ram, data_not_valid);
#endif
