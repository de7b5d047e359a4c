// EXPECT: an output of the scanner must be a register that can be written
#include <drivecodec/xd1000.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

#ifdef OK
constexpr auto no = scanner<outputs<cmd>, inputs<eta>>::configuration();
#else
constexpr auto no = scanner<outputs<eta>, inputs<eta>>::configuration();
#endif
