// EXPECT: ignoring return.*nodiscard
#include <drivecodec/core/result.hpp>

using namespace drivecodec;

result<int> send();

#ifdef OK
bool start() { return send().has_value(); }
#else
void start() { send(); }
#endif
