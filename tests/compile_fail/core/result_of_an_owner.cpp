// EXPECT: T must be trivially copyable
#include <drivecodec/core/result.hpp>
#include <string>

using namespace drivecodec;

#ifdef OK
std::size_t size(result<int> const&) { return sizeof(result<int>); }
#else
std::size_t size(result<std::string> const&) { return sizeof(result<std::string>); }
#endif
